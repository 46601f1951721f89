"""Pictures of folders that studies and crosschecks leave: what they draw and what they refuse."""

import json

import numpy as np

from tests.synthetic import TABLE, bowl, write_result
from tests.test_pictures import Pictures


def drape(representative: str, count: int, pivots: int = 0) -> dict:
    return {"count": count, "representative": representative, "total_energy_J": -1.5e-3, "negative_pivots": pivots}


class Folders(Pictures):
    def write(self, name: str, report: dict) -> None:
        (self.folder / name).write_text(json.dumps(report))


class Drapes(Folders):
    def study(self, *drapes: dict) -> None:
        group = {"values": ["1 mm"], "drapes": list(drapes)}
        self.write("study.json", {"format": "sundrape study", "title": "Drapes", "group_by": ["material.thickness"], "groups": [group]})

    def test_every_drape_has_its_panel(self):
        (self.folder / "runs").mkdir()
        write_result(self.folder / "runs/a.h5", bowl(frames=4), TABLE, analysis="relaxation")
        write_result(self.folder / "runs/b.h5", bowl(frames=2), analysis="relaxation")  # another scene: no table
        self.study(drape("runs/a.h5", 3), drape("runs/b.h5", 1, pivots=2))
        pixels = self.drawn("drapes", self.folder, "--size", "806x400")
        self.assertEqual(pixels.shape, (400, 806, 3))
        left, right = pixels[60:330, :400], pixels[60:330, 406:]
        for panel in (left, right):
            cloth = (panel[..., 0] > panel[..., 2] + 0.04).mean()  # linen is the only warm colour there
            self.assertGreater(cloth, 0.05)
        self.assertGreater(np.abs(left - right).mean(), 0.01)

    def test_a_study_without_results_and_what_is_no_study(self):
        self.study()
        self.refused(2, "no run of the study is done", "drapes", self.folder, "-o", self.png)
        self.write("study.json", {"format": "something else"})
        self.refused(2, 'its "format" is not "sundrape study"', "drapes", self.folder, "-o", self.png)
        (self.folder / "study.json").write_text("{")
        self.refused(2, "not a sundrape study", "drapes", self.folder, "-o", self.png)
        self.refused(3, "study.json: No such file", "drapes", self.folder / "absent", "-o", self.png)
        self.study(drape("runs/absent.h5", 1))
        self.refused(3, "absent.h5: No such file", "drapes", self.folder, "-o", self.png)


class Crosschecks(Folders):
    def crosscheck(self, shift: float) -> None:
        motion = bowl()
        write_result(self.folder / "relaxation.h5", motion, analysis="relaxation")
        second = motion.position[-1] + [0, 0, shift]
        pair = {"first": "relaxation", "second": "dynamics", "same_branch": shift == 0,
                "verdict": "same branch" if shift == 0 else "other branch", "second_position_m": second.tolist()}
        methods = [{"name": name, "result": f"{name}.h5"} for name in ("relaxation", "dynamics")]
        report = {"format": "sundrape crosscheck", "title": "Bowls", "size_m": 0.2, "methods": methods, "pairs": [pair]}
        self.write("crosscheck.json", report)

    def test_shapes_and_distances_are_drawn_without_a_display(self):
        self.crosscheck(0.03)
        pixels = self.drawn("crosscheck", self.folder, "--size", "900x420")
        self.assertEqual(pixels.shape, (420, 900, 3))
        shapes = pixels[:, :500]
        blue = (shapes[..., 2] > shapes[..., 0] + 0.4).mean()
        orange = (shapes[..., 0] > shapes[..., 2] + 0.4).mean()
        self.assertGreater(min(blue, orange), 1e-3)  # both nets are seen
        self.crosscheck(0)
        again = self.drawn("crosscheck", self.folder, "--size", "900x420")[:, :500]
        self.assertLess((again[..., 2] > again[..., 0] + 0.4).mean(), 0.7 * blue)  # the second covers the first

    def test_nothing_to_compare(self):
        self.write("crosscheck.json", {"format": "sundrape crosscheck", "title": "Bowls", "pairs": []})
        self.refused(2, "nothing to compare", "crosscheck", self.folder, "-o", self.png)


del Pictures  # its own tests are not ours to run again
