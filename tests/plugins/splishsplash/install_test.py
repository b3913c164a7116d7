#!/usr/bin/env python3
"""The script that puts the method into a checkout of SPlisHSPlasH, on files as that program's are."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
SCRIPT = HERE.parents[2] / "plugins/splishsplash/install.py"
REGISTRATION = "SPlisHSPlasH/NonPressureForceRegistration.cpp"
BUILD = "SPlisHSPlasH/CMakeLists.txt"
REGISTRATION_TEXT = """#include "Simulation.h"

#include "SurfaceTension/SurfaceTension_Akinci2013.h"

using namespace SPH;

void Simulation::registerNonpressureForces()
{
\taddSurfaceTensionMethod("None", [](FluidModel*) -> NonPressureForceBase* { return nullptr; });
\taddSurfaceTensionMethod(SurfaceTension_Akinci2013::METHOD_NAME, SurfaceTension_Akinci2013::creator);

\taddViscosityMethod("None", [](FluidModel*) -> NonPressureForceBase* { return nullptr; });
}
"""
BUILD_TEXT = """set(SURFACETENSION_SOURCE_FILES
\tSurfaceTension/SurfaceTension_Akinci2013.cpp
\t)

add_library(SPlisHSPlasH
\t${SURFACETENSION_SOURCE_FILES}
)
"""


class Install(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)
        (self.folder / "SPlisHSPlasH/SurfaceTension").mkdir(parents=True)
        (self.folder / REGISTRATION).write_text(REGISTRATION_TEXT)
        (self.folder / BUILD).write_text(BUILD_TEXT)

    def tearDown(self):
        self.temporary.cleanup()

    def run_script(self, *options, folder=None, status=0):
        done = subprocess.run([sys.executable, SCRIPT, folder or self.folder, *options],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, status, done.stderr)
        return done.stdout if status == 0 else done.stderr

    def files(self):
        return {path.relative_to(self.folder): path.read_bytes()
                for path in self.folder.rglob("*") if path.is_file()}

    def test_adds_registers_and_builds(self):
        output = self.run_script()
        self.assertIn("changed", output)
        self.assertIn('"Meniscus"', output)
        text = (self.folder / REGISTRATION).read_text()
        self.assertEqual(text.count("SurfaceTension_Meniscus::creator"), 1)
        # After the others, so that methods that scenes choose by number stay what they are.
        self.assertGreater(text.index("Meniscus::creator"), text.index("Akinci2013::creator"))
        self.assertLess(text.index("Meniscus::creator"), text.index("addViscosityMethod"))
        self.assertLess(text.index("SurfaceTension_Meniscus.h"), text.index("using namespace"))
        build = (self.folder / BUILD).read_text()
        self.assertLess(build.index("SurfaceTension_Meniscus.cpp"), build.index("add_library"))
        include = build.split('INCLUDE_DIRECTORIES "')[1].split('"')[0]
        self.assertTrue((Path(include) / "meniscus/runtime/version.hpp").is_file())
        self.assertTrue((self.folder / "SPlisHSPlasH/SurfaceTension/SurfaceTension_Meniscus.h").exists())

    def test_twice_is_once_and_remove_restores(self):
        before = self.files()
        self.run_script()
        once = self.files()
        self.assertNotIn("changed", self.run_script())
        self.assertEqual(self.files(), once)
        self.run_script("--remove")
        self.assertEqual(self.files(), before)
        self.run_script("--remove")
        self.assertEqual(self.files(), before)

    def test_keeps_line_ends(self):
        file = self.folder / REGISTRATION
        file.write_bytes(file.read_bytes().replace(b"\n", b"\r\n"))
        before = self.files()
        self.run_script()
        text = file.read_bytes()
        self.assertEqual(text.count(b"\n"), text.count(b"\r\n"))
        self.run_script("--remove")
        self.assertEqual(self.files(), before)

    def test_refuses_what_is_no_checkout(self):
        for message in (self.run_script(folder=self.folder / "SPlisHSPlasH", status=2),
                        self.run_script(folder=self.folder / "nowhere", status=2)):
            self.assertIn("checkout of SPlisHSPlasH", message)
            self.assertEqual(message.count("\n"), 1)
        self.assertIn("--include", self.run_script("--include", "/nowhere", status=2))
        (self.folder / BUILD).write_text("project(other)\n")
        before = self.files()
        self.assertIn("add_library(SPlisHSPlasH", self.run_script(status=2))
        self.assertEqual(self.files(), before)


if __name__ == "__main__":
    unittest.main()
