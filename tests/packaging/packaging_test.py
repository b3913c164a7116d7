#!/usr/bin/env python3
"""Recipes of packaging/ and the bill of materials against what the build says: versions, options,
libraries. Usage: packaging_test.py BUILD"""
import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
BUILD = Path(sys.argv.pop(1))
SPACK = (SOURCE / "packaging/spack/package.py").read_text()
PORT = (SOURCE / "packaging/vcpkg/portfile.cmake").read_text()
MANIFEST = json.loads((SOURCE / "packaging/vcpkg/vcpkg.json").read_text())
VERSION = re.search(r'MENISCUS_VERSION "([\d.]+)"',
                    (SOURCE / "runtime/version.hpp").read_text())[1]
# What CMake calls a library, in Spack and vcpkg.
LIBRARIES = {"CLI11": ("cli11", "cli11"), "Eigen3": ("eigen", "eigen3"), "fmt": ("fmt", "fmt"),
             "HDF5": ("hdf5", "hdf5"), "nlohmann_json": ("nlohmann-json", "nlohmann-json"),
             "OpenSSL": ("openssl", "openssl"), "ZLIB": ("zlib-api", "zlib"), "zstd": ("zstd", "zstd"),
             "MPI": (None, None), "OpenMP": (None, None), "Torch": ("py-torch", None),
             "Python": ("python", None), "pybind11": ("py-pybind11", None)}
# Folders that make what is installed.
INSTALLED = ("app", "bindings", "classifier", "data", "labeler", "sph")


def sbom(*arguments):
    return subprocess.run([sys.executable, "-B", SOURCE / "scripts/make_sbom.py", *arguments],
                          capture_output=True, text=True)


class Recipes(unittest.TestCase):
    def test_versions_are_the_project_s(self):
        self.assertEqual(MANIFEST["version"], VERSION)

    def test_options_exist(self):
        own = set(re.findall(r"option\((\w+)", (SOURCE / "CMakeLists.txt").read_text()))
        for text in (SPACK, PORT):
            named = set(re.findall(r"MENISCUS_[A-Z_]+", text))
            self.assertTrue(named)
            self.assertLessEqual(named, own)

    def test_libraries_are_those_that_the_build_looks_for(self):
        wanted = set()
        for folder in INSTALLED:
            for file in (SOURCE / folder).rglob("CMakeLists.txt"):
                wanted |= set(re.findall(r"find_package\((\w+)", file.read_text()))
        self.assertEqual(wanted, set(LIBRARIES))
        in_spack = set(re.findall(r'depends_on\("([a-z0-9-]+)', SPACK))
        in_vcpkg = {one if isinstance(one, str) else one["name"]
                    for one in MANIFEST["features"]["tools"]["dependencies"]}
        self.assertLessEqual({spack for spack, _ in LIBRARIES.values() if spack}, in_spack)
        self.assertEqual({port for _, port in LIBRARIES.values() if port}, in_vcpkg)

    def test_cmake_that_is_asked_for_is_the_least(self):
        least = re.search(r"cmake_minimum_required\(VERSION ([\d.]+)",
                          (SOURCE / "CMakeLists.txt").read_text())[1]
        self.assertIn(f'"cmake@{least}:"', SPACK)

    def test_the_recipe_is_python(self):
        compile(SPACK, "package.py", "exec")


class BillOfMaterials(unittest.TestCase):
    def test_names_what_was_found(self):
        done = sbom(BUILD)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, sbom(BUILD).stdout)
        bill = json.loads(done.stdout)
        self.assertEqual((bill["bomFormat"], bill["specVersion"]), ("CycloneDX", "1.5"))
        self.assertEqual(bill["metadata"]["component"]["version"], VERSION)
        versions = {one["name"]: one["version"] for one in bill["components"]}
        for name in ("hdf5", "openssl", "zlib", "zstd", "fmt", "cli11", "eigen", "nlohmann-json"):
            self.assertRegex(versions[name], r"^\d+\.\d+")
        self.assertEqual(bill["dependencies"][0]["dependsOn"], list(versions))

    def test_refuses_what_is_no_build(self):
        with tempfile.TemporaryDirectory() as folder:
            done = sbom(folder)
            self.assertEqual(done.returncode, 2)
            self.assertIn("CMake has configured", done.stderr)
            (Path(folder) / "dependencies.txt").write_text("hdf5|1.10\n")
            done = sbom(folder)
            self.assertEqual(done.returncode, 2)
            self.assertIn("line 1", done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)


if __name__ == "__main__":
    unittest.main()
