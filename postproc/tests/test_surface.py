"""The smooth surface and what keeps it outside the obstacles. Expected values are geometry."""

import unittest

import numpy as np

from sundrape_postproc.clearance import drape_over, lift_off, push_out
from sundrape_postproc.load import Obstacle
from sundrape_postproc.surface import SmoothSurface
from tests.synthetic import EVERY_KIND, square


def obstacle(kind: str, parameters: dict, position=(0, 0, 0), rotation=None) -> Obstacle:
    turn = np.eye(3) if rotation is None else np.reshape(rotation, (3, 3)).astype(float)
    return Obstacle(kind, parameters, np.asarray(position, dtype=float), turn)


class Smoothness(unittest.TestCase):
    def test_a_flat_square_stays_the_same_flat_square(self):
        nodes, quads = square(0.2, 6)
        points = SmoothSurface(quads, len(nodes)).points(nodes)
        np.testing.assert_allclose(points[:, 2], 0, atol=1e-15)
        np.testing.assert_allclose(points.max(axis=0), [0.1, 0.1, 0], atol=1e-12)

    def test_it_passes_through_the_nodes_and_near_the_true_surface_between(self):
        # a cylinder of radius 5 cm, cells of 1 cm: chords leave it by c²/8R = 0.25 mm
        nodes, quads = square(0.1, 10)
        bent = np.stack([0.05 * np.sin(nodes[:, 0] / 0.05), nodes[:, 1], 0.05 * np.cos(nodes[:, 0] / 0.05)], axis=1)
        points = SmoothSurface(quads, len(nodes)).points(bent)
        np.testing.assert_allclose(points[: len(nodes)], bent, atol=2e-5)
        inside = np.abs(nodes[:, 0]) < 0.035  # away from the free edges, where no curvature is known
        self.assertGreater(inside.sum(), 0)
        middle = points[np.abs(points[:, 0]) < 0.03]
        self.assertLess(np.abs(np.hypot(middle[:, 0], middle[:, 2]) - 0.05).max(), 0.03e-3)

    def test_every_level_quarters_the_quads_and_keeps_the_hem_closed(self):
        nodes, quads = square(0.2, 4)
        surface = SmoothSurface(quads, len(nodes))
        self.assertEqual(len(surface.quads), 16 * 4**3)
        self.assertTrue((np.bincount(surface.hem.ravel())[np.unique(surface.hem)] == 2).all())


class Clearance(unittest.TestCase):
    def setUp(self):
        self.points = np.random.default_rng(5).uniform(-0.25, 0.25, (20000, 3))

    def test_pushed_points_end_at_the_lift_and_the_others_stay(self):
        for name, entry in EVERY_KIND.items():
            with self.subTest(name):
                place = entry.get("position", (0, 0, 0))
                body = obstacle(entry["kind"], entry["parameters"], place, entry.get("rotation"))
                once = push_out(self.points, [body], 1e-3)
                moved = np.linalg.norm(once - self.points, axis=1) > 0
                self.assertTrue(0 < moved.sum() < len(moved))
                # at the surface + 1 mm a lift of 1 mm moves nothing, one of 2 mm moves all of them by 1 mm
                np.testing.assert_allclose(push_out(once, [body], 1e-3), once, atol=1e-9)
                again = np.linalg.norm(push_out(once[moved], [body], 2e-3) - once[moved], axis=1)
                np.testing.assert_allclose(again, 1e-3, atol=1e-9)

    def test_layers_on_a_body_keep_their_order_and_two_thirds_of_their_distance(self):
        ball = obstacle("sphere", {"radius": 0.05})
        heights = np.linspace(0, 0.01, 60)
        layers = np.outer(0.05 + heights, [0.6, 0, 0.8])
        lifted = np.linalg.norm(lift_off(layers, [ball], 1e-3), axis=1) - 0.05
        self.assertGreaterEqual(np.diff(lifted).min(), 2 / 3 * heights[1])
        self.assertAlmostEqual(lifted[0], 1e-3, places=12)
        self.assertLess(lifted[-1] - heights[-1], 0.04e-3)
        inside = lift_off(np.array([[0, 0, 0.049]]), [ball], 1e-3)
        np.testing.assert_allclose(inside, [[0, 0, 0.051]], atol=1e-12)

    def test_a_disc_ends_at_the_top_of_its_place(self):
        disc = obstacle("disc", {"radius": 0.05, "height": 0.1})
        np.testing.assert_allclose(push_out(np.array([[0, 0, -0.01]]), [disc], 0.0), [[0, 0, 0]], atol=1e-15)

    def test_a_mesh_that_cuts_a_tables_edge_is_bent_over_it(self):
        nodes, quads = square(0.04, 40)
        tilted = nodes @ np.array([[0.8, 0, -0.6], [0, 1, 0], [0.6, 0, 0.8]]) + [0.04, 0, -0.003]
        table = obstacle("box", {"size": [0.08, 0.08, 0.08], "edge_radius": 0.002}, (0, 0, -0.04))
        draped = drape_over(tilted, quads, [table], 1e-3)
        middles = draped[quads].mean(axis=1)
        np.testing.assert_allclose(push_out(middles, [table], 0.0), middles, atol=1e-12)


if __name__ == "__main__":
    unittest.main()
