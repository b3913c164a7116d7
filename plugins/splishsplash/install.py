#!/usr/bin/env python3
"""Puts meniscus' surface tension into a checkout of SPlisHSPlasH: copies the method's two files,
registers it, and adds it to the build. Run again after an update of either; --remove takes all of it
out again.

Usage: install.py CHECKOUT [--include FOLDER] [--remove]

FOLDER holds meniscus/runtime/ (default: that of this copy of meniscus). Exit status 2 where CHECKOUT
is none, with a line that says what was looked for.
"""
import argparse
import shutil
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
FILES = ("SurfaceTension_Meniscus.h", "SurfaceTension_Meniscus.cpp")
TARGET = Path("SPlisHSPlasH/SurfaceTension")
REGISTRATION = Path("SPlisHSPlasH/NonPressureForceRegistration.cpp")
BUILD = Path("SPlisHSPlasH/CMakeLists.txt")

INCLUDE = '#include "SurfaceTension/SurfaceTension_Meniscus.h"'
REGISTER = ("\taddSurfaceTensionMethod(SurfaceTension_Meniscus::METHOD_NAME, "
            "SurfaceTension_Meniscus::creator);")
# The program is C++11; the standard, and the headers of meniscus, are for this one file.
ADD = """\
list(APPEND SURFACETENSION_HEADER_FILES SurfaceTension/SurfaceTension_Meniscus.h)
list(APPEND SURFACETENSION_SOURCE_FILES SurfaceTension/SurfaceTension_Meniscus.cpp)
set_source_files_properties(SurfaceTension/SurfaceTension_Meniscus.cpp PROPERTIES
\tINCLUDE_DIRECTORIES "{include}"
\tCOMPILE_OPTIONS "$<IF:$<CXX_COMPILER_ID:MSVC>,/std:c++17,-std=c++17>")"""


class Refused(Exception):
    pass


def block(text, comment):
    """Text between the comments by which it is found again."""
    return f"{comment} meniscus: begin\n{text}\n{comment} meniscus: end\n"


def without_block(text, comment):
    """The text without all blocks, as it was."""
    begin, end = f"{comment} meniscus: begin\n", f"{comment} meniscus: end\n"
    while begin in text:
        before, rest = text.split(begin, 1)
        if end not in rest:
            raise Refused(f"'{begin.strip()}' has no '{end.strip()}' after it; restore the file "
                          "from your repository")
        text = before + rest.split(end, 1)[1]
    return text


def before_line(text, anchor, added, file):
    """The text with `added` before the first line that contains the anchor."""
    lines = text.splitlines(keepends=True)
    for number, line in enumerate(lines):
        if anchor in line:
            return "".join(lines[:number]) + added + "".join(lines[number:])
    raise Refused(f"{file} has no line with '{anchor}', where the method goes; is this "
                  "SPlisHSPlasH 2.9 or later?")


def registered(text, file):
    # After all others, whose numbers in scene files then stay.
    text = before_line(text, "using namespace SPH", block(INCLUDE, "//"), file)
    return before_line(text, "addViscosityMethod", block(REGISTER, "//"), file)


def built(text, file, include):
    return before_line(text, "add_library(SPlisHSPlasH", block(ADD.format(include=include), "#"),
                       file)


def patched(checkout, include, remove):
    """What each file is to hold."""
    texts = {}
    for name, comment in ((REGISTRATION, "//"), (BUILD, "#")):
        file = checkout / name
        if not file.is_file():
            raise Refused(f"{file} does not exist; give the folder of a checkout of SPlisHSPlasH")
        with open(file, newline="") as opened: # line ends as they are
            text = opened.read()
        clean = without_block(text.replace("\r\n", "\n"), comment)
        if not remove:
            clean = (registered(clean, name) if name == REGISTRATION
                     else built(clean, name, include))
        texts[file] = clean.replace("\n", "\r\n") if "\r\n" in text else clean
    return texts


def write(file, text):
    """Says whether it changed anything."""
    old = file.read_bytes() if file.exists() else None
    new = text if isinstance(text, bytes) else text.encode()
    if old != new:
        file.write_bytes(new)
    print(f"{file}: {'as it was' if old == new else 'changed' if old is not None else 'added'}")


def run(arguments):
    include = arguments.include.resolve()
    if not arguments.remove and not (include / "meniscus/runtime/version.hpp").is_file():
        raise Refused(f"{include}/meniscus/runtime/version.hpp does not exist; give --include the "
                      "folder that holds meniscus/runtime/")
    texts = patched(arguments.checkout, include.as_posix(), arguments.remove)
    for file, text in texts.items():
        write(file, text)
    for name in FILES:
        file = arguments.checkout / TARGET / name
        if not arguments.remove:
            file.parent.mkdir(exist_ok=True)
            write(file, (HERE / name).read_bytes())
        elif file.exists():
            file.unlink()
            print(f"{file}: removed")
    if not arguments.remove:
        print('Build it as before (CMake 3.11 or later), and choose "surfaceTensionMethod": '
              '"Meniscus" of a fluid.')


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("checkout", type=Path, help="folder of SPlisHSPlasH")
    parser.add_argument("--include", type=Path, default=HERE.parent.parent / "include",
                        help="folder that holds meniscus/runtime/")
    parser.add_argument("--remove", action="store_true", help="take it out again")
    try:
        run(parser.parse_args())
    except (Refused, OSError) as error:
        print(f"install.py: {error}", file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
