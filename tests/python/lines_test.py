#!/usr/bin/env python3
"""Lines are trained, judged, exported and applied as by the command, to the same bytes."""
import json

from support import DROPLET, SAMPLES, SOURCE, CommandTest, lattice, main, meniscus, np

OTHER = SAMPLES / "droplet_iisph_01.vtkhdf"


class Lines(CommandTest):
    def train(self, *options, files):
        model = self.folder / "model.json"
        self.command("train", *files, "-o", model, "--quiet", *options)
        return model

    def test_training_on_files(self):
        files = [self.labelled(DROPLET, "--features", "direction_eigenvalue"),
                 self.labelled(OTHER, "--features", "direction_eigenvalue")]
        pair = ("mass_offset", "direction_eigenvalue")
        line = meniscus.Line.train(files, label_threshold=0.02, second_features=pair)
        model = self.train("--label-threshold", 0.02, "--second-features", ",".join(pair),
                           files=files)
        self.assertEqual(line.to_json(), model.read_text())
        line.save(self.folder / "ours.json")
        self.assertEqual(meniscus.Line.load(self.folder / "ours.json").to_json(), line.to_json())

    def test_training_in_memory(self):
        states = [meniscus.label(meniscus.read(file)).snapshot for file in (DROPLET, OTHER)]
        line = meniscus.Line.train(states, label_threshold=0.02)
        expected = meniscus.Line.load(self.train("--label-threshold", 0.02, files=[
            self.labelled(DROPLET), self.labelled(OTHER)]))
        self.assertEqual((line.k, line.d, line.false_positives),
                         (expected.k, expected.d, expected.false_positives))
        kept = meniscus.Line.train(states[1:], keep_k=line)
        self.assertEqual(kept.k, line.k)
        self.assertNotEqual(kept.d, line.d)

    def test_audit(self):
        files = [self.labelled(DROPLET), self.labelled(OTHER)]
        line = meniscus.Line.train(files[:1], label_threshold=0.02)
        line.save(self.folder / "model.json")
        expected = json.loads(self.command("audit", *files, "--model", self.folder / "model.json",
                                           "--label-threshold", 0.02, "--format", "json"))
        self.assertEqual(meniscus.Line.load(self.folder / "model.json").audit(files), expected)
        in_memory = line.audit([meniscus.read(file) for file in files])
        for name in ("particles", "false_negatives", "false_positives",
                     "false_negatives_float", "false_positives_float"):
            self.assertEqual(in_memory["total"][name], expected["total"][name], name)

    def test_export(self):
        line = meniscus.Line.shipped(3, 2)
        line.export(self.folder / "ours.hpp", "Mine")
        self.command("export", SOURCE / "configs/models/surface_3d.json", "-o",
                     self.folder / "expected.hpp", "--name", "Mine", "--quiet")
        self.assertEqual((self.folder / "ours.hpp").read_bytes(),
                         (self.folder / "expected.hpp").read_bytes())

    def test_shipped_lines(self):
        for dimension, ratio, name in ((3, 2, ""), (3, 1.5, ""), (3, 2.6, "_wide"),
                                       (3, 4, "_widest"), (2, 2, ""), (2, 2.6, "_wide"),
                                       (2, 3, "_widest")):
            file = SOURCE / f"configs/models/surface_{dimension}d{name}.json"
            self.assertEqual(meniscus.Line.shipped(dimension, ratio).to_json(), file.read_text(),
                             (dimension, ratio))
        with self.assertRaisesRegex(meniscus.InputError, "spacing_ratio is 6, and the classifier"):
            meniscus.Line.shipped(3, 6)

    def test_a_moved_line_lets_more_through(self):
        state = meniscus.read(DROPLET)
        line = meniscus.Line.load(SOURCE / "configs/models/splishsplash_d28.json")
        found = [meniscus.classify(state, line=line.moved(by)).surface.sum() for by in (-8, 0, 8)]
        self.assertLess(found[0], found[1])
        self.assertLess(found[1], found[2])

    def test_classes(self):
        model = SOURCE / "configs/models/surface_3d.json"
        self.command("classify", DROPLET, "--model", model, "-o", self.folder / "out", "--quiet")
        expected = meniscus.read(self.folder / "out" / DROPLET.name).arrays
        classes = meniscus.classify(meniscus.read(DROPLET), line=meniscus.Line.load(model))
        self.assert_same(classes.surface, expected["predicted_surface"])
        self.assert_same(classes.valid, expected["valid"])
        self.assertGreater(classes.surface.sum(), 0)


class Refusals(CommandTest):
    def refuse(self, part, act, *arguments, **options):
        with self.assertRaisesRegex(meniscus.InputError, part):
            act(*arguments, **options)

    def test_what_cannot_be_trained_on(self):
        state = meniscus.Snapshot(lattice(4), support_radius=2.0)
        self.refuse("state 0", meniscus.Line.train, [state])
        self.refuse("", meniscus.Line.train, [])
        labelled = meniscus.label(state).snapshot
        self.refuse("no_such", meniscus.Line.train, [labelled], objective="no_such")
        self.refuse("label threshold", meniscus.Line.train, [labelled], label_threshold=2)
        self.refuse("found both", meniscus.Line.shipped(3, 2).audit, [labelled, self.labelled()])

    def test_same_words_as_the_command(self):
        broken = self.folder / "broken.json"
        broken.write_text('{"format": "meniscus model"}')
        with self.assertRaises(meniscus.InputError) as caught:
            meniscus.Line.load(broken)
        self.assertEqual(str(caught.exception), self.complaint(
            "export", broken, "-o", self.folder / "out.hpp"))

    def test_other_dimension(self):
        self.refuse("2D|dimension", meniscus.classify, lattice(4), 2.0,
                    line=meniscus.Line.shipped(2, 2))


if __name__ == "__main__":
    main()
