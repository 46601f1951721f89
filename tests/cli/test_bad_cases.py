"""Cases that cannot be run: one line says where and why, the exit status is 2, and nothing is left behind."""
import re
import unittest

from command_line import SHEET, CommandLineTest

QUADS = "v 0 0 0\nv .1 0 0\nv .1 .1 0\nv 0 .1 0\nv .2 0 0\nv .2 .1 0\ng cloth\nf 1 2 3 4\nf 2 5 6 3\n"
MESH = 'shape = "mesh"\nfile = "sheet.obj"'
RECTANGLE = 'shape = "rectangle"\nsize = ["8 cm", "6 cm"]\ncells = [4, 3]'

# what it shows: (replaced in the sheet, by what, key that is named, part of the reason)
SLIPS = {
    "unknown key": ("poisson =", "poison =", "material.poison", "did you mean 'poisson'"),
    "key of another table": ("poisson =", "rtol = 1e-3\npoisson =", "material.rtol", "belongs to dynamics"),
    "unit of another dimension": ('"0.5 mm"', '"0.5 kg"', "material.thickness", "a length is expected"),
    "unknown unit": ('"1 MPa"', '"1 MQa"', "material.youngs_modulus", "unknown unit"),
    "negative thickness": ('"0.5 mm"', '"-0.5 mm"', "material.thickness", "outside (0, inf)"),
    "NaN": ("density_area = 0.2", "density_area = nan", "material.density_area", "not a finite number"),
    "Poisson number of 0.7": ("poisson = 0.3", "poisson = 0.7", "material.poisson", "outside [0, 0.5)"),
    "truth for a number": ("poisson = 0.3", "poisson = true", "material.poisson", "true"),
    "relative tolerance of zero": ("rtol = 1e-3", "rtol = 0", "dynamics.rtol", "outside (0, 0.1]"),
    "no cells": ("cells = [4, 3]", "cells = [0, 3]", "cloth.cells", "outside [1, 10000]"),
    "no duration": ('duration = "20 ms"', "", "dynamics.duration", "missing"),
    "fixed step of a method that chooses its own": ('rtol = 1e-3', 'rtol = 1e-3\nstep = "1 ms"', "dynamics.step", "cvode"),
    "order that the method has not": ('rtol = 1e-3', 'rtol = 1e-3\nintegrator = "dirk"\nmax_order = 1', "dynamics.max_order", "outside [2, 5]"),
    "unknown analysis": ('"dynamics"', '"dynamic"', "analysis", "did you mean 'dynamics'"),
    "unknown model": ('"particle"', '"particles"', "model", "did you mean 'particle'"),
    "table given twice": ("[output]", "[dynamics]\n[output]", "", ""),
    "key given twice": ("rtol = 1e-3", "rtol = 1e-3\nrtol = 1e-4", "", ""),
    "not TOML": ("[material]", "[material", "", ""),
    "selector that picks nothing": ("near = [0, 0, 0]", "box = [[1, 1, 1], [2, 2, 2]]", "fix.0.nodes", "selects no node"),
    "set that the mesh has not": ("nodes = { near = [0, 0, 0] }", 'nodes = "lefft"', "fix.0.nodes", "left"),
    "supports in conflict": ("[[load]]", '[[fix]]\nnodes = { near = [0, 0, 0] }\n[[load]]', "fix.1.nodes", "in conflict"),
    "every node held": ('nodes = { near = [0, 0, 0] }\ncomponents = ["x", "y"]', 'nodes = "all"', "fix.0.nodes", "every node"),
    "force without nodes": ("[[obstacle]]", '[[load]]\nkind = "force"\ntotal = [1, 0, 0]\n[[obstacle]]', "load.1.nodes", "missing"),
    "moment on nodes that are no edge": ("[[obstacle]]", '[[load]]\nkind = "moment"\nnodes = { near = [0, 0, 0] }\ntotal = [0, 1e-6, 0]\n[[obstacle]]',
                                         "load.1.nodes", "edge"),
    "traction on nodes that are no edge": ("[[obstacle]]", '[[load]]\nkind = "traction"\nnodes = { near = [0, 0, 0] }\nper_length = [0, 1, 0]\n[[obstacle]]',
                                           "load.1.nodes", "edge"),
    "negative radius": ('kind = "plane"', 'kind = "sphere"\nradius = "-1 cm"', "obstacle.0.radius", "outside (0, inf)"),
    "obstacle mesh": ('kind = "plane"', 'kind = "mesh"\nfile = "sheet.obj"', "obstacle.0.file", "vertex index"),
    "normal without a length": ('kind = "plane"', 'kind = "plane"\nnormal = [0, 0, 0]', "obstacle.0.normal", "length"),
    "rounding wider than the box": ('kind = "plane"', 'kind = "box"\nsize = [1, 1, 1]\nedge_radius = 0.6', "obstacle.0.edge_radius", "outside [0, 0.5]"),
    "probes of one name": ('probes = [', 'probes = [ { name = "corner", near = [0, 0, 0] },', "output.probes.1.name", "two probes"),
    "missing mesh file": (RECTANGLE, MESH.replace("sheet", "none"), "cloth.file", "'none.obj' is not there"),
    "triangle in the mesh": (RECTANGLE, MESH.replace("sheet", "triangle"), "cloth.file", "triangle.obj:8"),
    "quadrilateral without an area": (RECTANGLE, MESH.replace("sheet", "flat"), "cloth.file", "flat.obj"),
    "vertex of no quadrilateral": (RECTANGLE, MESH.replace("sheet", "stray"), "cloth.file", "stray.obj"),
    "set that the mesh file has not": (RECTANGLE + '\nplace = { translate = [0, 0, "0.2 mm"] }',
                                       MESH + '\n[[fix]]\nnodes = "hem"', "fix.0.nodes", "hem"),
}


class BadCases(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.write("sheet.obj", QUADS)
        self.write("triangle.obj", QUADS.replace("f 1 2 3 4", "f 1 2 3"))
        self.write("flat.obj", QUADS.replace("v .2 .1 0", "v .2 0 0").replace("v .1 .1 0", "v .1 0 0"))
        self.write("stray.obj", QUADS.replace("g cloth", "v 1 1 1\ng cloth"))

    def refused(self, arguments, status, pattern):
        before = self.files()
        result = self.sundrape(*arguments)
        self.assertEqual(result.returncode, status, result.stderr)
        self.assertEqual(result.stdout, "")
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertRegex(lines[0], pattern)
        self.assertEqual(self.files(), before)

    def test_each_is_refused_with_its_file_line_key_and_reason(self):
        for name, (right, wrong, key, reason) in SLIPS.items():
            with self.subTest(name):
                self.assertEqual(SHEET.count(right), 1)
                case = self.write("bad.toml", SHEET.replace(right, wrong))
                place = rf"^bad\.toml:[1-9]\d*: {re.escape(key) + ': ' if key else ''}"
                self.refused(["run", case], 2, place + ".*" + re.escape(reason))

    def test_the_line_is_that_of_the_key(self):
        case = self.write("bad.toml", SHEET.replace("poisson = 0.3", "poisson = 0.7"))
        line = 1 + SHEET.splitlines().index("poisson = 0.3")
        self.refused(["run", case], 2, rf"^bad\.toml:{line}: ")

    def test_no_material(self):
        start, end = SHEET.index("[material]"), SHEET.index("[[fix]]")
        case = self.write("bad.toml", SHEET[:start] + SHEET[end:])
        self.refused(["run", case], 2, r"^bad\.toml:\d+: material: missing")

    def test_slips_on_the_command_line_name_themselves(self):
        case = self.write("good.toml", SHEET)
        for given, pattern in {
            "material.poisson=0.7": r"^--set material\.poisson=0\.7: material\.poisson: .*outside \[0, 0\.5\)",
            "material.poison=0.2": r"^--set material\.poison=0\.2: material\.poison: unknown key",
            "material.thickness='0.5 kg'": r"^--set .*: material\.thickness: .*length",
            "nonsense": r"^--set nonsense: ",
        }.items():
            with self.subTest(given):
                self.refused(["run", case, "--set", given], 2, pattern)

    def test_a_bad_command_line(self):
        case = self.write("good.toml", SHEET)
        for arguments in (["frobnicate"], ["run"], ["run", case, "--frobnicate"], ["run", case, "--threads", "0"], ["run", case, "--quiet", "-v"]):
            with self.subTest(arguments):
                self.refused(arguments, 2, "^sundrape: .*--help$")

    def test_files_that_cannot_be_read_or_written(self):
        case = self.write("good.toml", SHEET)
        for arguments, name in ((["run", "nowhere.toml"], "nowhere.toml"), (["run", "."], r"\."), (["info", case], case), (["info", "nowhere.h5"], "nowhere.h5"),
                                (["compare", case, case], case), (["run", case, "-o", "nowhere/out.h5"], "nowhere/out.h5"),
                                (["run", case, "--summary", "nowhere/out.json"], "nowhere/out.json"), (["run", case, "--resume", "nowhere.h5"], "nowhere.h5"),
                                (["run", case, "--resume", case, "-o", "out.h5"], case), (["run", case, "-o", case, "--force"], case)):
            with self.subTest(arguments):
                self.refused(arguments, 3, f"^{name}: ")


if __name__ == "__main__":
    unittest.main()
