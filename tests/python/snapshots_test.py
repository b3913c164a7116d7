#!/usr/bin/env python3
"""Snapshots: files come and go as in C++, and what cannot be one is refused."""

from support import SAMPLES, SOURCE, CommandTest, lattice, main, meniscus, np


class Snapshots(CommandTest):
    def test_what_is_read_is_written_again(self):
        read = meniscus.read(SAMPLES / "dam_dfsph_01.vtkhdf")
        meniscus.write(read, self.folder / "again.vtkhdf")
        self.assertEqual((self.folder / "again.vtkhdf").read_bytes(),
                         (SAMPLES / "dam_dfsph_01.vtkhdf").read_bytes())

    def test_arrays_of_a_foreign_file(self):
        read = meniscus.read(SOURCE / "tests/data/samples/pysph_dam_break.hdf5")
        self.assertEqual(read.dimension, 2)
        self.assertEqual(read.positions.shape, (read.size, 3))
        self.assertEqual(read.velocity.shape, (read.size, 3))
        self.assertGreater(len(read.boundary), 0)
        for values in (read.density, read.mass):
            self.assertEqual(values.shape, (read.size,))
            self.assertTrue((values > 0).all())

    def test_every_number_type(self):
        arrays = {name: np.arange(8).astype(name) for name in
                  ("int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64",
                   "float32", "float64")}
        arrays["vectors"] = np.arange(24.0).reshape(8, 3)
        for dtype in np.float32, np.float64:
            written = meniscus.Snapshot(lattice(2, dtype=dtype), dict(arrays), support_radius=2,
                                        time=0.5, scene="cube", particle_volume=1)
            meniscus.write(written, self.folder / "cube.vtkhdf")
            read = meniscus.read(self.folder / "cube.vtkhdf")
            self.assertEqual(read.positions.dtype, dtype)
            self.assert_same(read.positions, written.positions)
            self.assert_same_arrays(read.arrays, arrays)
            self.assertEqual((read.time, read.scene, read.support_radius, read.particle_volume),
                             (0.5, "cube", 2, 1))

    def test_arrays_that_are_not_contiguous(self):
        columns = np.asfortranarray(np.arange(24.0).reshape(8, 3))
        written = meniscus.Snapshot(lattice(2)[::-1], {"every_other": np.arange(16)[::2],
                                                       "columns": columns})
        meniscus.write(written, self.folder / "cube.vtkhdf")
        read = meniscus.read(self.folder / "cube.vtkhdf")
        self.assert_same(read.positions, lattice(2)[::-1])
        self.assert_same(read.arrays["every_other"], np.arange(0, 16, 2))
        self.assert_same(read.arrays["columns"], columns)

    def test_options_stand_in(self):
        read = meniscus.read(SAMPLES / "droplet_iisph_01.vtkhdf", support_radius=0.5, scene="mine")
        self.assertEqual((read.support_radius, read.scene), (0.5, "mine"))

    def test_states_of_a_trajectory(self):
        file = self.folder / "run.xyz"
        file.write_text("".join(f"1\nProperties=pos:R:3\n{x} 2 3\n" for x in range(3)))
        self.assertEqual(meniscus.read(file).positions[0, 0], 2)
        for frame in range(3):
            state = meniscus.read(file, frame=frame)
            self.assertEqual(state.positions[0, 0], frame)
            self.assertEqual(state.provenance["frame"], str(frame))
        with self.assertRaisesRegex(meniscus.InputError, "--frame 3: expected one of 0 to 2"):
            meniscus.read(file, frame=3)
        with self.assertRaisesRegex(meniscus.InputError, "frame must not be negative, found -1"):
            meniscus.read(file, frame=-1)

    def test_arrays_outlive_their_snapshot(self):
        positions = meniscus.read(SAMPLES / "droplet_iisph_01.vtkhdf").positions
        kept = positions.copy()
        meniscus.read(SAMPLES / "droplet_iisph_04.vtkhdf")
        self.assert_same(positions, kept)


class Refusals(CommandTest):
    def test_same_words_as_the_command(self):
        garbage = self.folder / "garbage.vtk"
        garbage.write_bytes(b"no snapshot\n")
        cut = self.folder / "cut.vtkhdf"
        cut.write_bytes((SAMPLES / "droplet_iisph_01.vtkhdf").read_bytes()[:20000])
        for file in garbage, cut:
            with self.assertRaises(meniscus.InputError) as caught:
                meniscus.read(file)
            self.assertEqual(str(caught.exception), self.complaint(
                "label", file, "-o", self.folder / "out", "--support-radius", "1"))

    def test_kinds_of_errors(self):
        self.assertTrue(issubclass(meniscus.InputError, meniscus.Error))
        self.assertTrue(issubclass(meniscus.InputError, ValueError))
        self.assertTrue(issubclass(meniscus.FailureError, meniscus.Error))
        self.assertTrue(issubclass(meniscus.FailureError, RuntimeError))

    def refuse(self, part, *arguments, **fields):
        with self.assertRaisesRegex(meniscus.InputError, part):
            meniscus.write(meniscus.Snapshot(*arguments, **fields), self.folder / "no.vtkhdf")
        self.assertFalse((self.folder / "no.vtkhdf").exists())

    def test_what_is_no_snapshot(self):
        self.refuse("positions must be an array of numbers", ["a", "b"])
        self.refuse(r"two or three coordinates a row, found the shape \(3,\)", np.zeros(3))
        self.refuse(r"found the shape \(3, 4\)", np.zeros((3, 4)))
        self.refuse("array 'mass' must have one row for each of 3 particles", np.zeros((3, 3)),
                    {"mass": np.ones(2)})
        self.refuse("array 'text' is of <U1, expected", np.zeros((1, 3)), {"text": ["a"]})
        self.refuse("boundary must have two or three", np.zeros((1, 3)), boundary=np.zeros(3))
        self.refuse("dimension is 2, but particle 1 has z = 5.0 and others before it 2.0",
                    np.arange(9.0).reshape(3, 3), dimension=2)
        self.refuse("dimension must be 2 or 3, found 4", np.zeros((1, 3)), dimension=4)

    def test_options_that_are_not_positive(self):
        with self.assertRaisesRegex(meniscus.InputError, "support_radius must be positive"):
            meniscus.read(SAMPLES / "droplet_iisph_01.vtkhdf", support_radius=-1)


if __name__ == "__main__":
    main()
