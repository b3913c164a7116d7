#!/usr/bin/env python3
"""Surface tension as an equation of PySPH: a square drop becomes a round one, under Laplace's pressure.

`SurfaceTensionForce` goes into any list of equations; the array that it acts on needs the properties
`st_x`, `st_y` and `st_z`. Neighbors are found anew, as PySPH keeps its own to itself.

Usage: 03_pysph_equation.py [OPTIONS OF PYSPH]    (--tf 6 ends after 6 s)
"""
import meniscus
import numpy as np
from pysph.base.kernels import CubicSpline
from pysph.base.utils import get_particle_array
from pysph.solver.application import Application
from pysph.sph.equation import Equation, Group
from pysph.sph.scheme import WCSPHScheme


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


class SquareDrop(Application):
    """A square of 1 m with the tension of 1 N/m and a density of 1 kg/m^2, slowed down by viscosity."""
    sigma, density, sound, spacing = 1.0, 1.0, 20.0, 0.05

    def create_particles(self):
        places = np.arange(-0.5 + self.spacing / 2, 0.5, self.spacing)
        x, y = (part.ravel() for part in np.meshgrid(places, places))
        drop = get_particle_array(name="fluid", x=x, y=y, m=self.density * self.spacing**2,
                                  rho=self.density, h=1.3 * self.spacing)
        self.scheme.setup_properties([drop])
        for name in ("st_x", "st_y", "st_z"):
            drop.add_property(name)
        return [drop]

    def create_scheme(self):
        scheme = WCSPHScheme(["fluid"], [], dim=2, rho0=self.density, c0=self.sound,
                             h0=1.3 * self.spacing, hdx=1.3, gamma=7.0, alpha=0.5, beta=0.0)
        scheme.configure_solver(kernel=CubicSpline(dim=2), dt=0.2 * self.spacing / self.sound, tf=6.0,
                                adaptive_timestep=False, pfreq=10**9)
        return scheme

    def create_equations(self):
        force = SurfaceTensionForce("fluid", ["fluid"], self.sigma, self.density, dimension=2)
        return [*self.scheme.get_equations(), Group(equations=[force])]


def rim_radii(drop, sectors=36):
    """Distance of the outermost particle from the center of mass, in sectors of equal angle."""
    x, y = drop.x - drop.x.mean(), drop.y - drop.y.mean()
    sector = ((np.arctan2(y, x) / (2 * np.pi) + 0.5) * sectors).astype(int) % sectors
    radius = np.hypot(x, y)
    return np.array([radius[sector == one].max() for one in range(sectors)]), radius


if __name__ == "__main__":
    app = SquareDrop()
    app.run()
    drop = app.particles[0]
    rim, radius = rim_radii(drop)
    laplace = app.sigma / np.sqrt(drop.m.sum() / app.density / np.pi) # of a disc of the same area
    inside = drop.p[radius < 0.5 * rim.mean()].mean()
    print(f"{drop.get_number_of_particles()} particles, net force "
          f"{abs((drop.m * drop.st_x).sum()) / abs(drop.m * drop.st_x).sum():.1e} of all forces, "
          f"rim {rim.min() / rim.mean():.3f} to {rim.max() / rim.mean():.3f} of its mean radius, "
          f"pressure {inside / laplace:.3f} of Laplace's")
