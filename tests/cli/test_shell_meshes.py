"""The meshes of the shell cases are those that their script writes."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

MESHES = pathlib.Path(__file__).parents[2] / "cases" / "meshes"


def numbers_and_words(path):
    return [[word for part in line.split() for word in part.split("/")] for line in path.read_text().splitlines()]


class ShellMeshes(unittest.TestCase):
    def test_are_what_the_script_writes(self):
        kept = sorted(MESHES.glob("*.obj"))
        self.assertTrue(kept)
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, MESHES / "shell_meshes.py", folder], check=True)
            self.assertEqual([p.name for p in kept], sorted(p.name for p in pathlib.Path(folder).iterdir()))
            for path in kept:
                lines, again = numbers_and_words(path), numbers_and_words(pathlib.Path(folder) / path.name)
                self.assertEqual([len(line) for line in lines], [len(line) for line in again], path.name)
                for line, other in zip(lines, again):
                    if line[0] in ("v", "vt"):  # the last digit is the mathematics library's
                        for x, y in zip(line[1:], other[1:]):
                            self.assertAlmostEqual(float(x), float(y), delta=1e-7, msg=path.name)
                    else:
                        self.assertEqual(line, other, path.name)


if __name__ == "__main__":
    unittest.main()
