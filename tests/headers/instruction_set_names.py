"""The inline namespace of the runtime's headers names all that changes code: files that are compiled
in different ways have different ones, so that a program may be made of both.

    instruction_set_names.py COMPILER INCLUDE_FOLDER
"""
import subprocess
import sys

WAYS = ["", "-msse3", "-mssse3", "-msse4.1", "-msse4.2", "-mavx", "-mavx2", "-mavx2 -mfma",
        "-mavx2 -mbmi", "-mavx2 -mbmi2", "-mavx2 -mlzcnt", "-march=haswell", "-mavx512f",
        "-mavx512f -mavx512vl", "-mavx512f -mavx512dq", "-mavx512f -mavx512bw",
        "-march=skylake-avx512", "-march=icelake-server", "-ffast-math", "-ffinite-math-only",
        "-fno-exceptions", "-march=haswell -ffast-math", "-march=haswell -fno-exceptions",
        "-DMENISCUS_BUILD=uncontracted"]
# Which leave traces with one of the compilers only.
OF_GCC = ["-freciprocal-math", "-fassociative-math -fno-signed-zeros -fno-trapping-math",
          "-fno-signed-zeros", "-funsafe-math-optimizations", "-frounding-math"]
SOURCE = "#include <meniscus/runtime/simd/instruction_set.hpp>\nMENISCUS_INSTRUCTION_SET\n"


def name_of(compiler, folder, way):
    command = [compiler, "-std=c++17", "-E", "-P", "-I", folder, "-x", "c++", *way.split(), "-"]
    return subprocess.run(command, input=SOURCE, check=True, capture_output=True,
                          text=True).stdout.split()[-1]


def main():
    compiler, folder = sys.argv[1:]
    version = subprocess.run([compiler, "--version"], check=True, capture_output=True, text=True)
    ways = WAYS + ([] if "clang" in version.stdout else OF_GCC)
    seen = {}
    for way in ways:
        name = name_of(compiler, folder, way)
        if not name.isidentifier():
            sys.exit(f"{way or 'no option'}: {name} is no name")
        if name in seen:
            sys.exit(f"{way} and {seen[name] or 'no option'} are both {name}")
        seen[name] = way
    print(f"{len(seen)} ways of compiling, {len(seen)} names")


main()
