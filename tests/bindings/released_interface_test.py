"""Holds what the C library offers (exported_interface.txt) against what the last release did
(released_interface.txt), so that no program stops working without being told.

    released_interface_test.py FOLDER CHANGELOG

Where a function, an enumerator or a member of a struct is gone or lies elsewhere, the changelog's
section of what is not released must say that programs are to be compiled again. Whoever releases
copies exported_interface.txt to released_interface.txt, under the line `release VERSION`, after
which a first or second number of the version above the one before stands for such a break.
"""
import re
import sys
from pathlib import Path

TOLD = "to be compiled again"


def facts_of(lines):
    """Each function, enumerator, struct and member with what is said of it."""
    facts = {}
    struct = ""
    for line in lines:
        if line.startswith("struct "):
            struct, size = line.split(": ")
            facts[struct] = size
        elif line.startswith("  "):
            name, place = line.strip().split(" at ")
            facts[f"{struct}, {name}"] = place
        elif line:
            name, _, value = line.partition(" = ")
            facts[name] = value
    return facts


def breaks_between(released, offered):
    """What a program that was built with the release would trip over."""
    now = facts_of(offered)
    return [f"{name}: {was or 'there'}, now {now.get(name, 'gone')}"
            for name, was in facts_of(released).items() if now.get(name) != was]


def sections_of(changelog):
    """Texts by their headings, the newest first."""
    parts = re.split(r"^## \[([^]]+)\].*$", changelog, flags=re.MULTILINE)[1:]
    return dict(zip(parts[::2], parts[1::2]))


def faults(released, offered, changelog):
    release, *lines = released.splitlines()
    sections = sections_of(changelog)
    latest = next(name for name in sections if name != "Unreleased")
    if release != f"release {latest}":
        return [f"released_interface.txt is of '{release}', the changelog's last release {latest}"]
    breaks = breaks_between(lines, offered.splitlines())
    if breaks and TOLD not in sections.get("Unreleased", ""):
        return [*breaks, f"the changelog does not say '{TOLD}'"]
    return []


def test_itself():
    old = "release 1.0.0\nfunction f\nstruct s: 8 bytes\n  a at 0, 8 bytes\nONE = 1\n"
    same = old.split("\n", 1)[1]
    quiet = "## [Unreleased]\n\n## [1.0.0]\n"
    assert faults(old, same, quiet) == []
    assert faults(old, same + "function g\nTWO = 2\n", quiet) == []
    for broken in (same.replace("function f\n", ""), same.replace("ONE = 1", "ONE = 2"),
                   same.replace("s: 8 bytes", "s: 16 bytes"), same.replace("a at 0", "a at 8")):
        assert len(faults(old, broken, quiet)) == 2, broken
        assert faults(old, broken, quiet.replace("\n\n", f"\nPrograms are {TOLD}.\n\n")) == []
    assert faults(old, same, "## [1.1.0]\n" + quiet)


folder, changelog = map(Path, sys.argv[1:])
test_itself()
found = faults((folder / "released_interface.txt").read_text(),
               (folder / "exported_interface.txt").read_text(), changelog.read_text())
print(*found, sep="\n", end="\n" if found else "")
sys.exit(1 if found else 0)
