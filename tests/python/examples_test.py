#!/usr/bin/env python3
"""The examples in Python run, and print what the command finds."""
import importlib.util
import json
import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

from support import SAMPLES, SOURCE, CommandTest, lattice, main, meniscus, np

EXAMPLES = SOURCE / "examples/python"


def needs(module, package):
    return unittest.skipIf(importlib.util.find_spec(module) is None,
                           f"{module} is missing; install {package}")


class Examples(CommandTest):
    def run_example(self, name, *words):
        """What it prints."""
        done = subprocess.run([sys.executable, EXAMPLES / name, *map(str, words)], text=True,
                              capture_output=True, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    @needs("matplotlib", "Debian's python3-matplotlib")
    def test_label_and_look(self):
        file = self.first_state("dam_break_2d")
        printed = self.run_example("01_label_and_look.py", file, self.folder / "picture.png")
        expected = self.command("label", file, "-o", self.folder / "labelled")
        self.assertIn(printed.strip(), expected)
        self.assertEqual((self.folder / "picture.png").read_bytes()[:4], b"\x89PNG")

    def test_train_and_move_d(self):
        names = ("droplet_iisph_01", "droplet_iisph_06", "droplet_iisph_14")
        files = [SAMPLES / (name + ".vtkhdf") for name in names]
        printed = self.run_example("02_train_and_move_d.py", *files)
        rows = {int(by): (int(missed), int(others)) for by, missed, others in re.findall(
            r"d ([+-]\d+): (\d+) missed, (\d+) false positives", printed)}
        ordered = [rows[by] for by in sorted(rows)]
        missed, others = zip(*ordered)
        self.assertEqual(list(missed), sorted(missed, reverse=True))
        self.assertEqual(list(others), sorted(others))
        self.assertGreater(rows[-4][0], rows[0][0])
        self.assertGreater(rows[4][1], rows[0][1])
        labelled = [self.labelled(file) for file in files]
        model = self.folder / "model.json"
        self.command("train", *labelled[:2], "-o", model, "--label-threshold", 0.02, "--quiet")
        total = json.loads(self.command("audit", labelled[2], "--model", model, "--label-threshold",
                                        0.02, "--format", "json"))["total"]
        self.assertEqual(rows[0], (total["false_negatives"], total["false_positives"]))

    def test_page(self):
        """What docs/python.md and the README show in Python."""
        dam = meniscus.read(SAMPLES / "dam_dfsph_01.vtkhdf", support_radius=0.1)
        meniscus.write(dam, self.folder / "dam.vtk") # told by its content
        positions = lattice(8)
        known = {"meniscus": meniscus, "positions": positions, "h": 2.0, "spacing": 1.0,
                 "masses": np.ones(len(positions)), "acceleration": np.zeros_like(positions)}
        os.chdir(self.folder)
        self.addCleanup(os.chdir, SOURCE)
        blocks = [block for page in ("docs/python.md", "README.md") for block in
                  re.findall(r"```python\n(.*?)```", (SOURCE / page).read_text(), re.DOTALL)]
        self.assertEqual(len(blocks), 3)
        for block in blocks:
            exec(block, known)
        self.assertIn("struct SurfaceCoefficients", Path("surface_coefficients.hpp").read_text())
        self.assertGreater(abs(known["acceleration"]).max(), 0)
        self.assertEqual(known["labels"].normal.shape, positions.shape)

    @needs("pysph", "Debian's python3-pysph")
    def test_pysph_equation(self):
        printed = self.run_example("03_pysph_equation.py", "-d", self.folder)
        share = float(re.search(r"net force (\S+) of all forces", printed)[1])
        self.assertLess(share, 1e-9) # of a drop that touches nothing
        smallest, largest = map(float, re.search(r"rim (\S+) to (\S+) of", printed).groups())
        self.assertGreater(smallest, 0.95) # a circle, to half a spacing; the square has 0.89 to 1.24
        self.assertLess(largest, 1.05)
        pressure = float(re.search(r"pressure (\S+) of Laplace's", printed)[1])
        self.assertAlmostEqual(pressure, 1, delta=0.1)


if __name__ == "__main__":
    main()
