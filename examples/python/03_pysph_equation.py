#!/usr/bin/env python3
"""Surface tension as an equation of PySPH: its elliptical drop, pulled together.

`SurfaceTensionForce` goes into any list of equations; the array that it acts on needs the properties
`st_x`, `st_y` and `st_z`. Neighbors are found anew, as PySPH keeps its own to itself.

Usage: 03_pysph_equation.py [OPTIONS OF PYSPH]
"""
import meniscus
import numpy as np
from pysph.examples.elliptical_drop import EllipticalDrop
from pysph.sph.equation import Equation, Group


class SurfaceTensionForce(Equation):
    """sigma in N/m; radius_scale is the kernel's; rest_density in kg/m^3 (in 2D kg/m^2)."""

    def __init__(self, dest, sources, sigma, rest_density, dimension=3, radius_scale=2.0):
        super().__init__(dest, sources)
        # What begins with an underscore stays in Python.
        self._sigma = sigma
        self._rest_density = rest_density
        self._dimension = dimension
        self._radius_scale = radius_scale
        self._tension = None

    def py_initialize(self, dst, t, dt):
        places = np.stack([dst.x, dst.y, dst.z], axis=1)
        radius = self._radius_scale * dst.h[0]
        if self._tension is None: # it keeps its memory
            spacing = (dst.m[0] / self._rest_density) ** (1 / self._dimension)
            self._tension = meniscus.SurfaceTension(self._dimension, surface_tension=self._sigma,
                                                    spacing_ratio=radius / spacing)
        state = meniscus.Snapshot(places, dimension=self._dimension, support_radius=radius)
        surface = self._tension.step(places, *meniscus.neighbors(state), dst.m,
                                     support_radius=radius, balance_momentum=True)
        force = surface.of_particles("force")
        for axis, name in enumerate(("st_x", "st_y", "st_z")[:self._dimension]):
            dst.get(name)[:] = force[:, axis] / dst.m

    def post_loop(self, d_idx, d_au, d_av, d_aw, d_st_x, d_st_y, d_st_z):
        d_au[d_idx] += d_st_x[d_idx]
        d_av[d_idx] += d_st_y[d_idx]
        d_aw[d_idx] += d_st_z[d_idx]


class PulledDrop(EllipticalDrop):
    def create_particles(self):
        arrays = super().create_particles()
        for name in ("st_x", "st_y", "st_z"):
            arrays[0].add_property(name)
        return arrays

    def create_equations(self):
        equations = super().create_equations()
        force = SurfaceTensionForce("fluid", ["fluid"], sigma=1000.0, rest_density=self.ro,
                                    dimension=2)
        return [*equations, Group(equations=[force])]


if __name__ == "__main__":
    app = PulledDrop()
    app.run()
    drop = app.particles[0]
    print(f"{drop.get_number_of_particles()} particles, net force "
          f"{abs((drop.m * drop.st_x).sum()) / abs(drop.m * drop.st_x).sum():.1e} of all forces")
