"""Fields on the nodes against shapes whose strain and curvature are known by hand."""

from __future__ import annotations

import unittest
from dataclasses import replace
from pathlib import Path

import numpy as np

from sundrape_postproc import fields
from sundrape_postproc.errors import PostprocError
from sundrape_postproc.load import Result


def sheet(columns: int, rows: int, size: tuple[float, float]) -> tuple[np.ndarray, np.ndarray]:
    """Nodes (N, 3) of a flat rectangle, x fastest, and its quads (E, 4)."""
    x, y = np.meshgrid(np.linspace(0, size[0], columns + 1), np.linspace(0, size[1], rows + 1))
    index = np.arange(x.size).reshape(x.shape)
    quads = np.stack([index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]], axis=-1).reshape(-1, 4)
    return np.stack([x.ravel(), y.ravel(), 0 * x.ravel()], axis=1), quads


def result_of(reference: np.ndarray, quads: np.ndarray, position: np.ndarray, model: str = "particle") -> Result:
    empty: dict = {}
    return Result(
        path=Path("shape.h5"),
        attributes={"model": model},
        time=np.zeros(1),
        position=position[None],
        reference=reference,
        material=reference[:, :2].copy(),
        quads=quads,
        energies=empty,
        residual=None,
        penetration=None,
        steps=empty,
        probes=empty,
        obstacles=empty,
        statistics=empty,
        units=empty,
    )


class Fields(unittest.TestCase):
    def setUp(self) -> None:
        self.reference, self.quads = sheet(12, 8, (0.3, 0.2))

    def test_strain_of_a_homogeneous_deformation_is_its_largest_stretch(self) -> None:
        deformation = np.array([[1.02, 0.05, 0], [0.01, 0.97, 0], [0.1, 0.2, 1]])
        largest = np.linalg.svd(deformation[:, :2], compute_uv=False)[0]
        turn = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
        skewed = self.reference + 0.3 * self.reference[:, [1]] * np.array([1.0, 0, 0])  # cells that are no rectangles
        for model in ("particle", "shell"):
            for rest in (self.reference, skewed):
                result = result_of(rest, self.quads, rest @ (turn @ deformation).T, model)
                np.testing.assert_allclose(fields.values(result, "strain", 0), largest - 1, atol=1e-12)

    def test_curvature_of_a_cylinder_is_one_over_its_radius(self) -> None:
        for cells in (12, 24):
            reference, quads = sheet(cells, 8, (0.3, 0.2))
            radius, angle = 0.1, reference[:, 0] / 0.1
            rolled = np.stack([radius * np.sin(angle), reference[:, 1], radius * (1 - np.cos(angle))], axis=1)
            curvature = fields.values(result_of(reference, quads, rolled), "curvature", 0).reshape(9, -1)
            inside = curvature[:, 2:-2]  # at the edge the normal is one-sided
            step = 0.3 / cells / radius
            np.testing.assert_allclose(inside, 1 / radius, rtol=step**2 / 4)

    def test_curvature_of_a_sphere_and_of_a_flat_sheet(self) -> None:
        flat = fields.values(result_of(self.reference, self.quads, self.reference), "curvature", 0)
        np.testing.assert_allclose(flat, 0, atol=1e-12)
        centred = self.reference - [0.15, 0.1, 0]
        ball = centred + [0, 0, 1] * np.sqrt(0.5**2 - (centred**2).sum(axis=1, keepdims=True))
        curvature = fields.values(result_of(self.reference, self.quads, ball), "curvature", 0).reshape(9, 13)
        np.testing.assert_allclose(curvature[2:-2, 2:-2], 2, rtol=0.01)

    def test_areas_sum_to_the_sheet(self) -> None:
        result = result_of(self.reference, self.quads, self.reference)
        areas = fields.node_areas(result)
        self.assertAlmostEqual(areas.sum(), 0.06, places=14)
        self.assertAlmostEqual(areas[0], 0.06 / 96 / 4, places=14)
        force = np.zeros((1, len(areas), 3))
        force[0, 0] = [0.3, 0, 0.4]
        pressure = fields.values(replace(result, contact_force=force), "contact", 0)
        self.assertAlmostEqual(pressure[0], 0.5 / areas[0])
        self.assertEqual(np.count_nonzero(pressure), 1)

    def test_collapsed_quads_have_finite_fields(self) -> None:
        result = result_of(self.reference, self.quads, 0 * self.reference)
        for name in ("strain", "curvature"):
            self.assertTrue(np.isfinite(fields.values(result, name, 0)).all(), name)

    def test_what_is_not_there_is_said(self) -> None:
        result = result_of(self.reference, self.quads, self.reference)
        self.assertEqual([f.name for f in fields.available(result)], ["strain", "curvature"])
        for name, said in (("energy", "has no energy density"), ("colour", "there are strain, curvature")):
            with self.assertRaisesRegex(PostprocError, said):
                fields.values(result, name, 0)


if __name__ == "__main__":
    unittest.main()
