# A recipe for Spack. In a repository of your own:
#     spack repo create my_repo; spack repo add my_repo
#     mkdir my_repo/packages/meniscus; cp packaging/spack/package.py my_repo/packages/meniscus/
# No release is published: `spack install meniscus@main` and `spack dev-build meniscus@main` work on a
# checkout that `git` names.
from spack.package import *


class Meniscus(CMakePackage):
    """Surface classifier and surface-tension toolkit for SPH fluids."""

    license("MIT")

    version("main", branch="main")

    variant("trainer", default=False, description="libtorch trainer (logistic, network, calibrate)")
    variant("python", default=True, description="Python module")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("cli11")
    depends_on("eigen@3.3:")
    depends_on("fmt")
    depends_on("hdf5~mpi")
    depends_on("nlohmann-json@3.10:")
    depends_on("openssl")
    depends_on("zlib-api")
    depends_on("zstd")
    depends_on("py-torch", when="+trainer")
    extends("python", when="+python")
    depends_on("python@3.9:", type=("build", "run"), when="+python")
    depends_on("py-pybind11@2.10:", type="build", when="+python")
    depends_on("py-numpy", type=("build", "run"), when="+python")

    def cmake_args(self):
        return [
            self.define_from_variant("MENISCUS_TRAINER", "trainer"),
            self.define_from_variant("MENISCUS_PYTHON", "python"),
            self.define("MENISCUS_TESTS", False),
            self.define("MENISCUS_BENCHMARKS", False),
        ]
