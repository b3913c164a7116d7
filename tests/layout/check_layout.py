#!/usr/bin/env python3
"""Checks who includes whom in the source tree, that the pages name files that exist and that what a
script fills in has one place, and prints the longest chains of includes.

Usage: check_layout.py FOLDER

A header and the source of the same name are one unit. Exit status 1 where a rule is broken, with a
line for each place that breaks one.
"""
import re
import sys
from pathlib import Path

# Which folders a folder may include from, besides itself. Data flows one way; nothing points back. A
# folder in another one stands for itself.
MAY_INCLUDE = {
    "runtime": set(),
    "data": {"runtime"},
    "labeler": {"runtime", "data"},
    "classifier": {"runtime", "data"},
    "sph": {"runtime", "data"},
    "bindings": {"runtime"},
    "bindings/python": {"runtime", "data", "labeler", "classifier", "sph", "bindings", "app"},
    "plugins": {"runtime"},
    "app": {"runtime", "data", "labeler", "classifier", "sph", "bindings", "bench",
            "validation"},
    # Plain oracles lie in tests/reference.
    "bench": {"runtime", "data", "labeler", "classifier", "sph", "bindings", "tests"},
    "validation": {"runtime", "data", "sph", "app", "bench"},
    "tests": {"runtime", "data", "labeler", "classifier", "sph", "bindings", "app", "bench",
              "validation"},
    # What a user has installed.
    "examples": {"runtime", "data", "labeler", "classifier", "bindings"},
}
# What a file's own folder does not hold is looked for here, as in compile_flags.txt.
SEARCHED = ("include", "tests", "bench", "validation")
COEFFICIENTS = Path("runtime/coefficients")
WRITTEN_BY_PROGRAM = re.compile(r"`meniscus export`; do not edit")
# What a test writes for itself while it is configured.
WRITTEN_BY_BUILD = {"all_headers.hpp", "readme_includes.hpp", "readme_lines.hpp"}


def sources(root):
    """All sources below the root, as paths relative to it."""
    return sorted({path.relative_to(root) for folder in MAY_INCLUDE
                   for path in (root / folder).rglob("*")
                   if path.suffix in (".hpp", ".cpp", ".h", ".c")})


def includes(root, path, errors):
    """The files of the tree that a file includes."""
    text = (root / path).read_text()
    for bracket, name in re.findall(r'^\s*#\s*include\s+([<"])([^>"]+)', text, re.MULTILINE):
        if bracket == "<" and not name.startswith("meniscus/") or name in WRITTEN_BY_BUILD:
            continue
        own = [] if bracket == "<" else [root / path.parent]
        found = [folder / name for folder in own + [root / folder for folder in SEARCHED]
                 if (folder / name).exists()]
        if not found or (".." in name and path.parts[0] != "runtime"):
            errors.append(f"{path}: {name} is not found or points out of its room; write "
                          "<meniscus/FOLDER/ROOM/FILE.hpp>")
        if found:
            yield found[0].resolve().relative_to(root.resolve())


def folder_of(path):
    """The folder of the table that a file lies in, the innermost one."""
    return max((folder for folder in MAY_INCLUDE if Path(folder) in path.parents), key=len)


def unit(path):
    return path.with_suffix("")


def room(unit):
    """The room that a unit lies in; its folder where it lies in none."""
    return Path(*unit.parts[:min(2, len(unit.parts) - 1)])


def check_arrow(path, other, errors):
    """One file includes another: may it?"""
    folder, of_other = folder_of(path), folder_of(other)
    if of_other != folder and of_other not in MAY_INCLUDE[folder]:
        errors.append(f"{path} includes {other}, but {folder}/ may include only from "
                      f"{', '.join(sorted(MAY_INCLUDE[folder])) or 'itself'}")
    if "detail" in other.parts:
        room = Path(*other.parts[:other.parts.index("detail")])
        if room not in path.parents:
            errors.append(f"{path} includes {other}, which {room}/ keeps for itself")


def check_generated(root, path, errors):
    """Headers that a program writes lie in one room, which holds nothing else."""
    written = bool(WRITTEN_BY_PROGRAM.search((root / path).read_text()[:1000]))
    if path.suffix == ".hpp" and written != (path.parent == COEFFICIENTS):
        errors.append(f"{path}: only headers that `meniscus export` writes lie in {COEFFICIENTS}/, and "
                      "all of them do")


def pages(root):
    return sorted([*root.glob("*.md"), *root.glob("docs/**/*.md")])


def check_pages(root, errors):
    """Links between files, and files that a page names by their whole path: NAME stands for any. The
    changelog also names files that are gone."""
    named = re.compile(rf"\b(?:{'|'.join(MAY_INCLUDE)}|configs|docs|scripts|cmake)/[\w/.-]+\.\w+\b")
    for page in pages(root):
        text = page.read_text()
        links = re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", text) + re.findall(r'src="([^":]+)"', text)
        missing = {name for name in links if not (page.parent / name).exists()}
        if page.name != "CHANGELOG.md":
            missing |= {name for name in named.findall(re.sub(r"\]\([^)]*\)", "", text))
                        if "/NAME." not in name and not (root / name).exists()
                        and not (root / "include/meniscus" / name).exists()}
        errors += [f"{page.relative_to(root)}: {name} does not exist" for name in sorted(missing)]


def check_marks(root, errors):
    """What scripts/update_docs.sh writes between comments has a place, and only one."""
    begun = {}
    for page in pages(root):
        name = page.relative_to(root)
        marks = re.findall(r"^<!-- (begin|end) (.+) -->$", page.read_text(), re.MULTILINE)
        for (kind, what), (end, other) in zip(marks[::2], marks[1::2] + [("", "")]):
            if (kind, end) != ("begin", "end") or what != other:
                errors.append(f"{name}: 'begin {what}' and 'end {what}' do not follow each other")
            if what in begun:
                errors.append(f"{name}: 'begin {what}' stands in {begun[what]}, too")
            begun[what] = name


def circle(graph):
    """Nodes of a circle, the first one repeated at the end, or none."""
    done, way = set(), []

    def visit(node):
        if node in way:
            return way[way.index(node):] + [node]
        if node in done:
            return []
        way.append(node)
        for other in sorted(graph.get(node, ())):
            if found := visit(other):
                return found
        way.pop()
        done.add(node)
        return []

    for node in sorted(graph):
        if found := visit(node):
            return found
    return []


def without_circles(graph, name, errors):
    """The graph less what closes a circle, of which each is an error."""
    cut = dict(graph)
    while found := circle(cut):
        errors.append(f"{name}: " + " -> ".join(map(str, found)))
        cut[found[-2]] = cut[found[-2]] - {found[-1]}
    return cut


def rooms_of(graph, errors):
    """Which rooms include from which, the tests' own aside. Rooms stand on one another, too."""
    rooms = {}
    for node, others in graph.items():
        if node.parts[0] not in ("bench", "validation", "tests"):
            rooms.setdefault(room(node), set()).update(map(room, others))
    return without_circles({node: others - {node} for node, others in rooms.items()},
                           "a circle of rooms", errors)


def longest_chain(graph):
    """The longest way through a graph without circles."""
    longest = {}

    def chain(node):
        if node not in longest:
            longest[node] = [node] + max((chain(other) for other in sorted(graph.get(node, ()))),
                                         key=len, default=[])
        return longest[node]

    return max((chain(node) for node in sorted(graph)), key=len, default=[])


def check(root):
    """What breaks a rule, and who includes whom by units."""
    errors, graph = [], {}
    for path in sources(root):
        check_generated(root, path, errors)
        others = graph.setdefault(unit(path), set())
        for other in includes(root, path, errors):
            check_arrow(path, other, errors)
            if unit(other) != unit(path):
                others.add(unit(other))
    check_pages(root, errors)
    check_marks(root, errors)
    return errors, without_circles(graph, "a circle", errors)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    errors, graph = check(Path(sys.argv[1]))
    for kind, nodes in ("rooms", rooms_of(graph, errors)), ("files", graph):
        for folder in ("runtime", "sph"):
            inside = {node: {other for other in others if other.parts[0] == folder}
                      for node, others in nodes.items() if node.parts[0] == folder}
            chain = longest_chain(inside)
            print(f"{folder}/: {len(chain)} levels of {kind}, " + " -> ".join(map(str, chain)))
    for error in errors:
        print(error, file=sys.stderr)
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
