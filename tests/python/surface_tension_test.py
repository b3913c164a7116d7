#!/usr/bin/env python3
"""A step finds what `meniscus classify` finds, bit for bit, and refuses what it cannot read."""
import threading
import warnings

from support import DROPLET, SOURCE, CommandTest, lattice, main, meniscus, np

MODEL = SOURCE / "configs/models/surface_3d.json"
FOUND = {"surface_class": "surface_class", "runtime_uncovered_fraction": "uncovered_fraction",
         "runtime_normal": "normal", "runtime_curvature": "curvature", "runtime_force": "force"}


class Steps(CommandTest):
    def expect_classified(self, state, dimension, model, options, **arguments):
        """A step over the state's lists gives what the command has written."""
        warnings.simplefilter("ignore") # lines hold for other spacings than some samples have
        expected = meniscus.read(self.folder / "out" / (self.file.stem + ".vtkhdf")).arrays
        line = meniscus.Line.load(model)
        classes = meniscus.classify(state, line=line)
        tension = meniscus.SurfaceTension(dimension, line=line,
                                          spacing_ratio=classes.spacing_ratio, **options)
        ids = None if state.id is None else state.id.astype(np.uint32)
        radius = state.arrays.get("support_radius", state.support_radius)
        surface = tension.step(state.positions.astype(np.float64), *meniscus.neighbors(state),
                               support_radius=radius, ids=ids, candidates=classes.surface,
                               **arguments)
        self.assertGreater(len(surface.particle), 0)
        for name, ours in FOUND.items():
            values = surface.of_particles(ours)
            if values.ndim == 2 and dimension == 2:
                values = np.pad(values, ((0, 0), (0, 1)))
            self.assert_same(values, expected[name])

    def classify(self, file, model, *options):
        self.file = file
        self.command("classify", file, "--model", model, "-o", self.folder / "out", "--quiet",
                     *options)
        return meniscus.read(file)

    def test_as_the_command(self):
        state = self.classify(DROPLET, MODEL, "--samples", 64, "--tau", 0.4, "--balance-momentum")
        self.expect_classified(state, 3, MODEL, {"samples": 64, "tau": 0.4},
                               balance_momentum=True)

    def test_paper(self):
        state = self.classify(DROPLET, MODEL, "--paper", "--coverage", "exact")
        self.expect_classified(state, 3, MODEL, {"paper": True, "coverage": "exact"})

    def test_boundary(self):
        for dimension, scene in (3, "resting_tank"), (2, "dam_break_2d"):
            model = SOURCE / f"configs/models/surface_{dimension}d.json"
            state = self.classify(self.first_state(scene), model, "--balance-momentum")
            offsets, indices = meniscus.boundary_neighbors(state)
            self.assertGreater(len(indices), 0)
            self.expect_classified(state, dimension, model, {}, boundary_positions=state.boundary,
                                   boundary_offsets=offsets, boundary_indices=indices,
                                   balance_momentum=True)

    def test_radii_that_vary(self):
        places = lattice(10)
        meniscus.write(meniscus.Snapshot(places, support_radius=2 + 0.01 * places[:, 0]),
                       self.folder / "two.vtkhdf")
        self.expect_classified(self.classify(self.folder / "two.vtkhdf", MODEL), 3, MODEL, {})

    def steps(self, *tensions):
        places = lattice(8)
        lists = meniscus.neighbors(places, 2.0)
        return [tension.step(places, *lists, support_radius=2.0) for tension in tensions]

    def test_numbers_of_threads(self):
        one, two = self.steps(*(meniscus.SurfaceTension(threads=threads) for threads in (1, 2)))
        self.assert_same(one.force, two.force)

    def test_types_of_lists(self):
        places = lattice(8)
        offsets, indices = meniscus.neighbors(places, 2.0)
        tension = meniscus.SurfaceTension()
        expected = tension.step(places, offsets, indices, support_radius=2.0)
        for offset_type in np.int32, np.uint32, np.int64:
            for index_type in np.int32, np.int64, np.uint64:
                found = tension.step(places, offsets.astype(offset_type),
                                     indices.astype(index_type), support_radius=2.0)
                self.assert_same(found.force, expected.force)

    def test_float(self):
        places = lattice(8, dtype=np.float32)
        lists = meniscus.neighbors(places, 2.0)
        in_float = meniscus.SurfaceTension(dtype=np.float32).step(places, *lists, support_radius=2)
        in_double = meniscus.SurfaceTension().step(places, *lists, support_radius=2)
        self.assertEqual(in_float.force.dtype, np.float32)
        self.assert_same(in_float.particle, in_double.particle)
        np.testing.assert_allclose(in_float.force, in_double.force, rtol=1e-3,
                                   atol=1e-3 * abs(in_double.force).max())

    def test_padded_positions_are_read_in_place(self):
        places = lattice(8)
        padded = np.pad(places, ((0, 0), (0, 1)), constant_values=np.nan)
        lists = meniscus.neighbors(places, 2.0)
        tension = meniscus.SurfaceTension()
        self.assert_same(tension.step(padded, *lists, support_radius=2.0).force,
                         tension.step(places, *lists, support_radius=2.0).force)

    def test_results_outlive_the_step(self):
        tension = meniscus.SurfaceTension()
        first = self.steps(tension)[0]
        kept = first.force.copy()
        tension.set_samples(512)
        self.steps(tension)
        self.assert_same(first.force, kept)

    def test_options_that_change_are_those_of_a_new_object(self):
        tension = meniscus.SurfaceTension(surface_tension=1, fade=0)
        tension.set_surface_tension(0.072)
        tension.set_fade(0.5)
        tension.set_smoothing(1, 3)
        tension.set_contact_angle(60)
        new = meniscus.SurfaceTension(surface_tension=0.072, fade=0.5, normal_passes=1,
                                      curvature_passes=3, contact_angle=60)
        self.assert_same(self.steps(tension)[0].force, self.steps(new)[0].force)

    def test_an_option_out_of_its_range_changes_nothing(self):
        tension = meniscus.SurfaceTension()
        expected = self.steps(tension)[0].force
        for change, name in ((lambda: tension.set_surface_tension(float("inf")), "surface_tension"),
                             (lambda: tension.set_contact_angle(200), "contact_angle"),
                             (lambda: tension.set_fade(float("nan")), "fade"),
                             (lambda: tension.set_smoothing(1, -1), "curvature_passes")):
            with self.assertRaisesRegex(meniscus.InputError, name):
                change()
        self.assert_same(self.steps(tension)[0].force, expected)

    def test_one_object_in_several_threads(self):
        tension = meniscus.SurfaceTension()
        expected = self.steps(tension)[0].force
        found = []
        threads = [threading.Thread(target=lambda: found.append(self.steps(tension)[0].force))
                   for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(len(found), 4)
        for force in found:
            self.assert_same(force, expected)

    def test_masses_and_equal_radii(self):
        places = lattice(8)
        lists = meniscus.neighbors(places, 2.0)
        tension = meniscus.SurfaceTension()
        plain = tension.step(places, *lists, support_radius=2.0)
        given = tension.step(places, *lists, np.full(len(places), 3.0),
                             support_radius=np.full(len(places), 2.0))
        self.assert_same(given.particle, plain.particle)
        np.testing.assert_allclose(given.force, plain.force, rtol=1e-9, atol=1e-12)


class Refusals(CommandTest):
    def setUp(self):
        super().setUp()
        self.places = lattice(4)
        self.offsets, self.indices = meniscus.neighbors(self.places, 2.0)
        self.tension = meniscus.SurfaceTension()

    def refuse(self, part, act="step", **changed):
        given = {"positions": self.places, "offsets": self.offsets, "indices": self.indices,
                 "support_radius": 2.0, **changed}
        with self.assertRaisesRegex(meniscus.InputError, part):
            getattr(self.tension, act)(**given)

    def test_lists_that_point_nowhere(self):
        beyond = self.indices.copy()
        beyond[5] = 64
        self.refuse(r"indices\[5\] is 64, expected a particle below 64", indices=beyond)
        negative = self.indices.astype(np.int32)
        negative[7] = -1
        self.refuse(r"indices\[7\] is 4294967295", indices=negative)
        self.refuse(r"indices\[7\] is 4294967295", indices=negative.astype(np.int64))
        self.refuse("offsets ends with", indices=self.indices[:-1])
        falling = self.offsets.copy()
        falling[3] = 0
        self.refuse(r"offsets\[3\] is smaller", offsets=falling)

    def test_shapes_and_types(self):
        self.refuse("positions must have at least 3 coordinates a row", positions=np.zeros((64, 2)))
        self.refuse("offsets must have 65 entries", offsets=self.offsets[:-1])
        self.refuse("offsets must be one row of whole numbers", offsets=self.offsets.astype(float))
        self.refuse("indices must be one row of whole numbers", indices=self.indices * 1.0)
        self.refuse("masses must have 64 entries", masses=np.ones(3))
        self.refuse("support_radius must have 64 entries", support_radius=np.ones(3))
        self.refuse("support_radius must be positive", support_radius=-1.0)
        self.refuse("boundary_positions must have as many columns",
                    boundary_positions=np.zeros((1, 4)), boundary_offsets=self.offsets,
                    boundary_indices=self.indices)

    def test_check(self):
        lost = self.places.copy()
        lost[9, 1] = np.inf
        self.refuse(r"positions\[9\] is not finite", "check", positions=lost)
        masses = np.ones(64)
        masses[2] = 0
        self.refuse(r"masses\[2\] is not positive", "check", masses=masses)
        half = np.array([j for i in range(64) for j in
                         self.indices[self.offsets[i]:self.offsets[i + 1]] if j > i], np.uint32)
        counts = [sum(self.indices[self.offsets[i]:self.offsets[i + 1]] > i) for i in range(64)]
        self.refuse("lists are whole", "check", indices=half,
                    offsets=np.concatenate(([0], np.cumsum(counts))))

    def test_options(self):
        for options, part in (({"tau": 2}, "tau must be between 0 and 1, found 2"),
                              ({"samples": 3.5}, "samples must be a whole number"),
                              ({"samples": 1}, "samples must be a whole number"),
                              ({"coverage": "none"}, "coverage must be sampled or exact, found none"),
                              ({"spacing_ratio": 9}, "spacing_ratio is 9, and the classifier"),
                              ({"dimension": 4}, "dimension must be 2 or 3"),
                              ({"dtype": np.int32}, "dtype must be float32 or float64"),
                              ({"line": meniscus.Line.shipped(2, 2)}, "2D|dimension")):
            with self.assertRaisesRegex(meniscus.InputError, part):
                meniscus.SurfaceTension(**options)
        with self.assertWarnsRegex(UserWarning, "outside what it was trained on"):
            meniscus.SurfaceTension(line=meniscus.Line.shipped(3, 2), spacing_ratio=4)
        with self.assertRaisesRegex(TypeError, "another type than its hint"):
            self.tension.step(self.places, self.offsets, self.indices, support_radius=None)
        with self.assertRaisesRegex(TypeError, "no option 'sigma'; it has k, d,"):
            meniscus.SurfaceTension(sigma=1)


if __name__ == "__main__":
    main()
