#!/usr/bin/env python3
"""Writes a software bill of materials (CycloneDX 1.5, JSON) of a build: what CMake found, by
cmake/dependencies.cmake. The same build gives the same bytes.

Usage: make_sbom.py BUILD [-o FILE]     (default: standard output)
"""
import argparse
import json
import sys
import uuid
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent
SCOPES = ("required", "optional", "excluded")


class Refused(Exception):
    pass


def version():
    line = next(line for line in (SOURCE / "runtime/version.hpp").read_text().splitlines()
                if line.startswith("#define MENISCUS_VERSION"))
    return line.split('"')[1]


def license_of(text):
    """An identifier where it is one, else an expression (SPDX)."""
    return {"expression": text} if " " in text else {"license": {"id": text}}


def component(line, place):
    parts = line.split("|")
    if len(parts) != 4 or parts[3] not in SCOPES:
        raise Refused(f"{place}: found '{line}', expected name|version|license|scope; configure the "
                      "build again")
    name, found, license, scope = parts
    return {"type": "library", "bom-ref": name, "name": name, "version": found, "scope": scope,
            "licenses": [license_of(license)], "purl": f"pkg:generic/{name}@{found}"}


def sbom(build):
    file = build / "dependencies.txt"
    if not file.is_file():
        raise Refused(f"{file} does not exist; give the folder of a build that CMake has configured")
    components = [component(line, f"{file}, line {number}")
                  for number, line in enumerate(file.read_text().splitlines(), 1)]
    own = {"type": "application", "bom-ref": "meniscus", "name": "meniscus", "version": version(),
           "licenses": [license_of("MIT")], "purl": f"pkg:generic/meniscus@{version()}"}
    content = json.dumps([own, components])
    return {"bomFormat": "CycloneDX", "specVersion": "1.5",
            "serialNumber": f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_URL, content)}", "version": 1,
            "metadata": {"component": own}, "components": components,
            "dependencies": [{"ref": "meniscus", "dependsOn": [one["bom-ref"] for one in components]}]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("build", type=Path)
    parser.add_argument("-o", "--output", type=Path)
    arguments = parser.parse_args()
    try:
        text = json.dumps(sbom(arguments.build), indent=1) + "\n"
        if arguments.output:
            arguments.output.write_text(text)
        else:
            sys.stdout.write(text)
    except (Refused, OSError) as error:
        print(f"make_sbom.py: {error}", file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
