"""Looks at the object files of kernels (runtime/simd/begin_kernel.hpp), of which those for wider
instruction sets end in _avx2 and _avx512.
- Each uses the registers of its set.
- What the linker shares between files, weak functions of other names than the set's own, has no
  instruction that an older machine lacks: all of those begin with v.

    kernel_objects.py OBJECT...
"""
import re
import subprocess
import sys

REGISTERS = {"avx2": "%ymm", "avx512": "%zmm"}


def weak_functions(path):
    symbols = subprocess.run(["nm", path], check=True, capture_output=True, text=True).stdout
    return {line.split()[-1] for line in symbols.splitlines() if re.search(r" [WV] ", line)}


def functions(path):
    """Name and disassembly of each."""
    text = subprocess.run(["objdump", "-d", "--no-show-raw-insn", path],
                          check=True, capture_output=True, text=True).stdout
    parts = re.split(r"^[0-9a-f]+ <(.+)>:$", text, flags=re.MULTILINE)
    return zip(parts[1::2], parts[2::2])


def is_own(name, instruction_set):
    """Of the set's inline namespace, also where the name is an argument of a template."""
    return f"{len(instruction_set)}{instruction_set}" in name


def complaints(path, instruction_set):
    weak = weak_functions(path)
    wide = 0
    for name, code in functions(path):
        wide += code.count(REGISTERS[instruction_set])
        if name in weak and not is_own(name, instruction_set):
            new = re.search(r"\t(v[a-z]\S* .*|k\w+ +%k.*)", code)
            if new:
                yield f"{path}: {name}, which others share, has `{new[1]}`"
    if wide == 0:
        yield f"{path}: no instruction uses {REGISTERS[instruction_set]}"


def main():
    kernels = [(path, found[1]) for path in sys.argv[1:]
               if (found := re.search(r"_kernel_(avx2|avx512)\.cpp\.o$", path))]
    found = [complaint for path, of_set in kernels for complaint in complaints(path, of_set)]
    print("\n".join(found + [f"{len(kernels)} kernels looked at"]))
    sys.exit(1 if found or not kernels else 0)


main()
