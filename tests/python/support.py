"""What the tests of the Python module share: the command that its answers are held against, folders
that are gone in the end, and small fluids. Ends the program with 77, which ctest takes for skipped,
where NumPy is missing."""
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import numpy as np
except ImportError:
    print("skipped: NumPy is missing; install Debian's python3-numpy")
    sys.exit(77)

import meniscus

SOURCE = Path(os.environ["MENISCUS_SOURCE"])
SAMPLES = SOURCE / "data/samples"
DROPLET = SAMPLES / "droplet_iisph_06.vtkhdf"


class CommandTest(unittest.TestCase):
    """A test with a folder of its own, and the command to compare with."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def command(self, *words):
        """What the command prints on standard output; it must succeed."""
        done = subprocess.run([os.environ["MENISCUS_PROGRAM"], *map(str, words)],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def complaint(self, *words):
        """The line that the command fails with, without its name in front."""
        done = subprocess.run([os.environ["MENISCUS_PROGRAM"], *map(str, words)],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 2, done.stderr)
        return done.stderr.strip().removeprefix("meniscus: ")

    def labelled(self, file=DROPLET, *options):
        """The file as the command labels it."""
        self.command("label", file, "-o", self.folder / "labelled", "--quiet", *options)
        return self.folder / "labelled" / (file.stem + ".vtkhdf")

    def first_state(self, scene):
        """A file with the first state of a scene, walls included."""
        file = self.folder / (scene + ".vtkhdf")
        meniscus.write(meniscus.Simulation(SOURCE / f"configs/scenes/{scene}.json").snapshot(), file)
        return file

    def assert_same(self, found, expected):
        """Bit for bit, whatever the number type."""
        np.testing.assert_array_equal(found, expected)

    def assert_same_arrays(self, found, expected):
        self.assertEqual(found.keys(), expected.keys())
        for name, values in expected.items():
            self.assertEqual(found[name].dtype, values.dtype, name)
            self.assert_same(found[name], values)


def main():
    """Runs the tests of the program; ends with 77 where all are skipped, having said why."""
    result = unittest.main(exit=False, verbosity=2 if len(sys.argv) > 1 else 1).result
    if result.testsRun > 0 and len(result.skipped) == result.testsRun:
        sys.exit(77)
    sys.exit(not result.wasSuccessful())


def lattice(edge, dimension=3, jitter=0.1, dtype=np.float64):
    """edge^dimension particles, about 1 apart."""
    axes = np.meshgrid(*dimension * [np.arange(float(edge))], indexing="ij")
    places = np.stack(axes, axis=-1).reshape(-1, dimension)
    return (places + jitter * np.random.default_rng(1).uniform(-1, 1, places.shape)).astype(dtype)
