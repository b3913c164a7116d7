#!/usr/bin/env python3
"""Neighbor lists, features and labels are those of the command, bit for bit."""
import threading

from support import DROPLET, SAMPLES, CommandTest, lattice, main, meniscus, np


class Labels(CommandTest):
    def expect_labels(self, labels, file):
        """The labels and the labelled snapshot of a file that the command has labelled."""
        expected = meniscus.read(file)
        for name in ("uncovered_fraction", "surface", "valid", "mass_offset", "neighbor_count"):
            self.assert_same(getattr(labels, name), expected.arrays[name])
        self.assert_same_arrays(labels.snapshot.arrays, expected.arrays)
        self.assertEqual(labels.snapshot.particle_volume, expected.particle_volume)
        of_files = {name: expected.provenance.pop(name, None) for name in ("input", "input_hash", "request")}
        self.assertEqual(len(of_files["input_hash"]), 64)
        self.assertEqual(labels.snapshot.provenance, expected.provenance)

    def test_exact(self):
        for file in DROPLET, SAMPLES / "crown_dfsph_02.vtkhdf":
            self.expect_labels(meniscus.label(meniscus.read(file)), self.labelled(file))

    def test_monte_carlo(self):
        self.expect_labels(meniscus.label(meniscus.read(DROPLET), samples=500, seed=7),
                           self.labelled(DROPLET, "--samples", 500, "--seed", 7))

    def test_boundary_and_two_dimensions(self):
        for scene in "resting_tank", "dam_break_2d":
            file = self.first_state(scene)
            state = meniscus.read(file)
            self.assertGreater(len(state.boundary), 0)
            self.expect_labels(meniscus.label(state), self.labelled(file))
            self.expect_labels(meniscus.label(state, boundary_weight=0.5),
                               self.labelled(file, "--boundary-weight", 0.5))

    def test_radii_that_vary(self):
        places = lattice(10)
        state = meniscus.Snapshot(places, support_radius=2 + 0.01 * places[:, 0])
        meniscus.write(state, self.folder / "two.vtkhdf")
        self.expect_labels(meniscus.label(state), self.labelled(self.folder / "two.vtkhdf"))

    def test_a_written_file_is_that_of_the_command(self):
        file = self.labelled()
        labelled = meniscus.label(meniscus.read(DROPLET)).snapshot
        for name in "input", "input_hash", "request":
            labelled.provenance[name] = meniscus.read(file).provenance[name]
        meniscus.write(labelled, self.folder / "ours.vtkhdf")
        self.assertEqual((self.folder / "ours.vtkhdf").read_bytes(), file.read_bytes())

    def test_features(self):
        names = list(meniscus.feature_meanings)
        expected = meniscus.read(self.labelled(DROPLET, "--features", "all")).arrays
        found = meniscus.features(meniscus.read(DROPLET), names=names)
        self.assertEqual(list(found), names)
        for name in names:
            self.assert_same(found[name], expected[name])

    def test_number_of_threads(self):
        one, two = (meniscus.label(meniscus.read(DROPLET), threads=threads) for threads in (1, 2))
        self.assert_same(one.uncovered_fraction, two.uncovered_fraction)

    def test_float_and_double_positions(self):
        places = lattice(8, dtype=np.float32)
        labels = [meniscus.label(places.astype(dtype), 2.0) for dtype in (np.float32, np.float64)]
        self.assert_same(labels[0].uncovered_fraction, labels[1].uncovered_fraction)

    def test_normals_point_out_of_a_ball(self):
        places = lattice(17) - 8
        ball = places[np.linalg.norm(places, axis=1) < 7.5]
        labels = meniscus.label(ball, 2.0, normals=True)
        lengths = np.linalg.norm(labels.normal, axis=1)
        self.assert_same(lengths[labels.surface == 0], 0)
        open_ones = labels.uncovered_fraction > 0.1 # pinholes look anywhere
        np.testing.assert_allclose(lengths[open_ones], 1, rtol=1e-12)
        outward = ball[open_ones] / np.linalg.norm(ball[open_ones], axis=1)[:, None]
        self.assertGreater((labels.normal[open_ones] * outward).sum(axis=1).min(), 0.5)

    def test_several_threads_of_python(self):
        expected = meniscus.label(meniscus.read(DROPLET)).uncovered_fraction
        found = []
        threads = [threading.Thread(target=lambda: found.append(
            meniscus.label(meniscus.read(DROPLET)).uncovered_fraction)) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(found), 4)
        for labels in found:
            self.assert_same(labels, expected)


class Neighbors(CommandTest):
    def test_against_all_pairs(self):
        for dimension in 2, 3:
            places = lattice(5, dimension)
            offsets, indices = meniscus.neighbors(places, 2.0)
            distances = np.linalg.norm(places[:, None] - places, axis=-1)
            near = (distances < 2.0) & ~np.eye(len(places), dtype=bool)
            self.assert_same(np.diff(offsets), near.sum(axis=1))
            for i, row in enumerate(near):
                self.assert_same(np.sort(indices[offsets[i]:offsets[i + 1]]), np.flatnonzero(row))

    def test_phases_are_apart(self):
        state = meniscus.Snapshot([[0.0, 0], [1, 0], [0, 1]], {"phase": np.array([0, 0, 1])},
                                  support_radius=2)
        offsets, indices = meniscus.neighbors(state)
        self.assert_same(offsets, [0, 1, 2, 2])
        self.assert_same(indices, [1, 0])

    def test_radii_that_vary(self):
        offsets, _ = meniscus.neighbors([[0.0, 0], [1, 0], [2.2, 0]], [0.8, 1.3, 1.0])
        self.assert_same(np.diff(offsets), [1, 1, 0])

    def test_no_particle(self):
        offsets, indices = meniscus.neighbors(np.zeros((0, 3)), 1.0)
        self.assertEqual((list(offsets), len(indices)), ([0], 0))


class Refusals(CommandTest):
    def refuse(self, part, *arguments, **options):
        with self.assertRaisesRegex(meniscus.InputError, part):
            meniscus.label(*arguments, **options)

    def test_options_out_of_range(self):
        places = lattice(3)
        self.refuse("radius ratio must lie between 0 and 1, found 1.5", places, 2, radius_ratio=1.5)
        self.refuse("support radi", places)
        self.refuse("must be positive", places, -1.0)
        self.refuse("no_such", places, 2, features=["no_such"])
        self.refuse("no_such", places, 2, scheme="no_such")
        places[3] = np.nan
        self.refuse("3", places, 2)
        self.assertEqual(meniscus.label(places, 2, skip_invalid=True).valid.sum(), 26)

    def test_implausible_radius_warns(self):
        with self.assertWarnsRegex(UserWarning, "mean neighbor count .* is implausible in 3D"):
            meniscus.label(lattice(3), 1.05)


if __name__ == "__main__":
    main()
