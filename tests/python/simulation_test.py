#!/usr/bin/env python3
"""A scene that runs in Python comes to the same bits as by the command."""
import json

from support import SOURCE, CommandTest, main, meniscus, np

STEP = 1 / 1024 # frames are then at times without rounding


class Simulations(CommandTest):
    def scene(self):
        file = self.folder / "drop.json"
        file.write_text(json.dumps({
            "name": "drop", "particle_spacing": 0.1, "duration": 4 * STEP, "frame_interval": STEP,
            "fluid": [{"lattice": {"first": [0, 0, 0], "count": [6, 6, 6]}}],
            "pressure": {"solver": "dfsph"},
            "surface_tension": {"model": "meniscus", "coefficient": 10},
            "viscosity": {"kinematic": 0.01}, "time_step": {"fixed": STEP}}))
        return file

    def test_frames_of_the_command(self):
        self.command("simulate", self.scene(), "-o", self.folder, "--quiet")
        simulation = meniscus.Simulation(self.scene())
        for frame in range(5):
            expected = meniscus.read(self.folder / f"drop_{frame:04}.vtkhdf")
            self.assertEqual(simulation.time, expected.time)
            self.assert_same(simulation.positions, expected.positions)
            self.assert_same(simulation.velocities.astype(np.float32), expected.velocity)
            self.assert_same_arrays(simulation.snapshot().arrays, expected.arrays)
            report = simulation.step()
            self.assertEqual(report.time_step, STEP)
            self.assertTrue(report.converged)

    def test_run_ends_in_time(self):
        simulation = meniscus.Simulation(self.scene(), changes={"time_step": {"fixed": 0.4 * STEP}})
        simulation.run(STEP)
        self.assertAlmostEqual(simulation.time, STEP, delta=1e-12)
        self.assertEqual(simulation.size, 216)

    def test_variants_and_changes(self):
        file = SOURCE / "configs/scenes/double_droplet.json"
        small = meniscus.Simulation(file)
        large = meniscus.Simulation(file, variant="paper")
        self.assertEqual(small.size, 2 * 12 ** 3)
        self.assertGreater(large.size, small.size)
        self.assertEqual((small.name, small.dimension), ("double_droplet", 3))

    def test_refusals(self):
        for options, part in (({"variant": "huge"}, "huge"),
                              ({"changes": {"no_such_key": 1}}, "no_such_key"),
                              ({"changes": {"particle_spacing": -1}}, "particle_spacing")):
            with self.assertRaisesRegex(meniscus.InputError, part):
                meniscus.Simulation(self.scene(), **options)
        with self.assertRaisesRegex(meniscus.InputError, "nowhere.json"):
            meniscus.Simulation(self.folder / "nowhere.json")

    def test_divergence(self):
        simulation = meniscus.Simulation(self.scene(), changes={
            "domain": {"low": [-1, -1, -1], "high": [2, 2, 2]}, "gravity": [0, 0, -1e6]})
        with self.assertRaisesRegex(meniscus.FailureError, "diverged|left|moved"):
            simulation.run(1)
        with self.assertRaisesRegex(meniscus.FailureError, "diverged in an earlier step"):
            simulation.step()


if __name__ == "__main__":
    main()
