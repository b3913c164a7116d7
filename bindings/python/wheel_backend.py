"""Makes a wheel of the Python module for `pip install .` (PEP 517): CMake builds and installs it, and
what it installed is packed as it is. Needs nothing but Python, CMake and what the build needs, so
that it works without an index.

`pip install . --config-settings build-folder=build/release` takes a build folder that is configured
already in place of one of its own, build/wheel.
"""
import base64
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
VERSION = re.search(r'MENISCUS_VERSION "([\d.]+)"', (SOURCE / "runtime/version.hpp").read_text())[1]
TAG = "cp{0}{1}-cp{0}{1}-{2}".format(*sys.version_info[:2],
                                     re.sub(r"[-.]", "_", sysconfig.get_platform()))
INFO = f"meniscus-{VERSION}.dist-info"
METADATA = f"""\
Metadata-Version: 2.1
Name: meniscus
Version: {VERSION}
Summary: Surface classifier and surface-tension toolkit for SPH fluids
License: MIT
Requires-Python: >=3.9
Requires-Dist: numpy
"""
WHEEL = f"""\
Wheel-Version: 1.0
Generator: meniscus
Root-Is-Purelib: false
Tag: {TAG}
"""


def configure(build):
    """Of the project only what the module needs; for the Python that runs this."""
    subprocess.run(["cmake", "-S", SOURCE, "-B", build, "-DCMAKE_BUILD_TYPE=Release",
                    f"-DPython_EXECUTABLE={sys.executable}", "-DMENISCUS_PYTHON=ON",
                    "-DMENISCUS_TESTS=OFF", "-DMENISCUS_BENCHMARKS=OFF",
                    "-DMENISCUS_TRAINER=OFF"], check=True)


def installed_package(build, prefix):
    """The package's folder below the prefix, after CMake has built and installed it there."""
    if not (build / "CMakeCache.txt").exists():
        configure(build)
    subprocess.run(["cmake", "--build", build, "--target", "meniscus_python", "--parallel",
                    str(os.cpu_count())], check=True)
    subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", prefix],
                   check=True)
    compiled = "_meniscus" + sysconfig.get_config_var("EXT_SUFFIX")
    for found in Path(prefix).rglob(compiled):
        return found.parent
    sys.exit(f"{build}: is not configured for {sys.executable}, or was without pybind11 or Python's "
             "development files; remove it or name another build-folder")


def record_line(name, content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Writes what is known without a build into the folder, and returns its place there."""
    folder = Path(metadata_directory) / INFO
    folder.mkdir()
    (folder / "METADATA").write_text(METADATA)
    (folder / "WHEEL").write_text(WHEEL)
    return INFO


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Writes the wheel into the folder and returns its name."""
    build = Path((config_settings or {}).get("build-folder", SOURCE / "build/wheel")).resolve()
    name = f"meniscus-{VERSION}-{TAG}.whl"
    with tempfile.TemporaryDirectory() as prefix:
        package = installed_package(build, prefix)
        files = {file.relative_to(package.parent).as_posix(): file.read_bytes()
                 for file in sorted(package.rglob("*")) if file.is_file()}
    files[f"{INFO}/METADATA"] = METADATA.encode()
    files[f"{INFO}/WHEEL"] = WHEEL.encode()
    record = "".join(record_line(*file) for file in files.items()) + f"{INFO}/RECORD,,\n"
    files[f"{INFO}/RECORD"] = record.encode()
    with zipfile.ZipFile(Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for file, content in files.items():
            wheel.writestr(file, content)
    return name


class UnsupportedOperation(Exception):
    """What PEP 517 has for a hook that is not there."""


def build_sdist(sdist_directory, config_settings=None):
    raise UnsupportedOperation("the source archive of meniscus is its repository")
