"""Compares what the shared C library offers with exported_interface.txt: the symbols that it exports,
which all begin with meniscus_, and the structs and enumerators of its header.

    exported_interface_test.py LIBRARY PROGRAM FILE

PROGRAM is exported_interface.c. Whoever changes the interface on purpose writes the file anew, by
what this prints after --print in the place of FILE, and says so in the changelog: programs built
before must be built again.
"""
import difflib
import subprocess
import sys
from pathlib import Path


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def main():
    library, program, file = sys.argv[1:]
    symbols = sorted(line.split()[-1] for line in
                     output_of("nm", "-D", "--defined-only", library).splitlines())
    found = "".join(f"function {symbol}\n" for symbol in symbols) + output_of(program)
    if file == "--print":
        print(found, end="")
        return
    foreign = [symbol for symbol in symbols if not symbol.startswith("meniscus_")]
    changes = list(difflib.unified_diff(Path(file).read_text().splitlines(), found.splitlines(),
                                        file, "this build", lineterm=""))
    print("\n".join([f"exported, but none of ours: {symbol}" for symbol in foreign] + changes))
    sys.exit(1 if foreign or changes else 0)


main()
