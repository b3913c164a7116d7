#!/usr/bin/env python3
"""check_layout.py finds each kind of break, and none in a tree that has none."""
import tempfile
import unittest
from pathlib import Path

from check_layout import check, longest_chain, rooms_of

SOUND = {
    "runtime/coefficients/line.hpp": "// Written by `meniscus export`; do not edit.\n",
    "runtime/surface/detail/part.hpp": "",
    "runtime/surface/step.hpp": '#include "../coefficients/line.hpp"\n#include "detail/part.hpp"\n',
    "data/formats/csv.hpp": "",
    "data/formats/csv.cpp": '#include "csv.hpp"\n#include <vector>\n',
    "sph/step/run.cpp": "#include <meniscus/runtime/surface/step.hpp>\n",
}


def errors_of(changed):
    """Of the sound tree with other files in it."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for name, text in {**SOUND, **changed}.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        (root / "include/meniscus").mkdir(parents=True)
        for name in ("runtime", "data", "sph"):
            (root / "include/meniscus" / name).symlink_to(root / name)
        errors, graph = check(root)
        rooms_of(graph, errors)
        return errors


class CheckLayout(unittest.TestCase):
    def expect(self, changed, *parts):
        """One error, which mentions the parts."""
        errors = errors_of(changed)
        self.assertEqual(len(errors), 1, errors)
        for part in parts:
            self.assertIn(part, errors[0])

    def test_sound_tree(self):
        self.assertEqual(errors_of({}), [])

    def test_circle_of_headers(self):
        self.expect({"runtime/surface/detail/part.hpp": '#include "../step.hpp"\n'},
                    "circle", "runtime/surface/step -> runtime/surface/detail/part")

    def test_circle_through_a_source(self):
        self.expect({"data/formats/csv.cpp": '#include "files.hpp"\n',
                     "data/formats/files.hpp": '#include "csv.hpp"\n'}, "circle")

    def test_circle_of_rooms(self):
        self.expect({"data/formats/csv.hpp": "#include <meniscus/data/text/text.hpp>\n",
                     "data/text/text.hpp": "",
                     "data/text/cells.hpp": "#include <meniscus/data/formats/pysph.hpp>\n",
                     "data/formats/pysph.hpp": ""}, "a circle of rooms")

    def test_arrow_out_of_a_folder_in_another(self):
        self.assertEqual(errors_of({
            "bindings/python/module.cpp": "#include <meniscus/data/formats/csv.hpp>\n"}), [])
        self.expect({"bindings/c/interface.cpp": "#include <meniscus/data/formats/csv.hpp>\n"},
                    "bindings/ may include only from")

    def test_arrow_between_folders(self):
        self.expect({"data/formats/csv.hpp": "#include <meniscus/sph/step/step.hpp>\n",
                     "sph/step/step.hpp": ""}, "data/ may include only from runtime")

    def test_detail_of_another_room(self):
        self.expect({"sph/step/run.cpp": "#include <meniscus/runtime/surface/detail/part.hpp>\n"},
                    "runtime/surface/ keeps for itself")

    def test_coefficients_written_by_hand(self):
        self.expect({"runtime/coefficients/own.hpp": ""}, "runtime/coefficients/own.hpp")

    def test_coefficients_elsewhere(self):
        self.expect({"sph/step/line.hpp": SOUND["runtime/coefficients/line.hpp"]}, "sph/step/line.hpp")

    def test_missing_header(self):
        self.expect({"sph/step/run.cpp": '#include "nothing.hpp"\n'}, "nothing.hpp is not found")

    def test_way_out_of_a_room(self):
        self.expect({"sph/step/run.cpp": '#include "../run/log.hpp"\n', "sph/run/log.hpp": ""},
                    "points out of its room")

    def test_link_to_nothing(self):
        self.expect({"docs/page.md": "[A](../runtime/surface/step.hpp#top), [b](gone.md)"},
                    "docs/page.md: gone.md does not exist")
        self.expect({"docs/data/page.md": '<img src="gone.png">'},
                    "docs/data/page.md: gone.png does not exist")

    def test_page_names_a_file_that_is_gone(self):
        self.expect({"README.md": "`data/formats/csv.cpp` and `data/csv.cpp`"},
                    "README.md: data/csv.cpp does not exist")

    def test_tables_of_the_docs_with_two_places_or_none(self):
        place = "<!-- begin a -->\n<!-- end a -->\n"
        self.assertEqual(errors_of({"docs/page.md": place}), [])
        self.expect({"docs/page.md": place, "docs/data/page.md": place}, "'begin a' stands in")
        self.expect({"docs/page.md": "<!-- begin a -->\n"}, "do not follow each other")
        self.expect({"docs/page.md": "<!-- begin a -->\n<!-- end b -->\n"}, "'begin a' and 'end a'")

    def test_longest_chain(self):
        self.assertEqual(longest_chain({"a": {"b", "d"}, "b": {"c"}, "c": {"d"}}), ["a", "b", "c", "d"])


if __name__ == "__main__":
    unittest.main()
