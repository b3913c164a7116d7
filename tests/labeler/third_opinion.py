"""Exact labels of the shipped samples against areas by FreeSASA, which shares nothing with them.

Lambda of a particle is the solvent-accessible surface of an atom of radius h among atoms of radius
0.8 h, for a probe of radius 0, over 4 pi h^2. FreeSASA has two ways to find it, both approximate:
slices through the atom (Lee and Richards) and points on it (Shrake and Rupley).

Arguments: the program meniscus, and the folder of the samples.
"""
import pathlib
import subprocess
import sys
import tempfile

try:
    import freesasa
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOHDF import vtkHDFReader
except ImportError as error:
    sys.exit(f"FreeSASA's or VTK's Python module or NumPy is missing ({error}); on Debian: "
             "apt-get install python3-freesasa python3-vtk9 python3-numpy")

# As runtime/neighbors/neighborhood.hpp states them, written anew so that nothing is shared.
RADIUS_RATIO = 0.8
NEIGHBOR_BAND = 1e-5

SURFACE_PARTICLES = 16  # of each sample
INTERIOR_PARTICLES = 8
SEED = 20

# FreeSASA's own error shrinks with n; that of a wrong lambda does not, so that one off by 2e-5
# exceeds the last tolerance of slices. Each of n slices stands for 1/n of the sphere, and they err
# most where the edge of a cap passes close to an exposed pole: by up to 0.11 / n in eight sets of
# particles (other seeds; 300 and 3000 slices). Points err by up to 1.5 n^-3/4 (1000 and 10000
# points). Both tolerances are about twice that.
ALGORITHMS = {
    freesasa.LeeRichards: ("n-slices", (300, 3000, 30000), lambda n: 0.25 / n),
    freesasa.ShrakeRupley: ("n-points", (1000, 10000, 100000), lambda n: 3 * n**-0.75),
}


def read(path):
    reader = vtkHDFReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def one_of_each_part(particles, key, parts, generator):
    """Sorts the particles by key, cuts them into equal parts, and draws one from each."""
    ordered = particles[numpy.argsort(key[particles], kind="stable")]
    return [generator.choice(part) for part in numpy.array_split(ordered, parts)]


def neighbors(positions, i, support_radius):
    """Displacements to the neighbors of i, in support radii."""
    displacements = (positions - positions[i]) / support_radius
    distances = numpy.sqrt((displacements**2).sum(axis=1))
    inner = (1 - RADIUS_RATIO) * (1 + NEIGHBOR_BAND)
    outer = 1 - NEIGHBOR_BAND
    return displacements[(distances > inner) & (distances < outer)]


def random_turn(generator):
    rotation, _ = numpy.linalg.qr(generator.normal(size=(3, 3)))
    return rotation


def area_fraction(displacements, algorithm, resolution, number):
    """Exposed part of a sphere of radius 1 among spheres around its neighbors, by FreeSASA."""
    parameters = freesasa.Parameters({"algorithm": algorithm, "probe-radius": 0.0, resolution: number})
    # A sphere inside the particle's own covers nothing, but without it Shrake and Rupley's crashes
    # on a particle that has no neighbor.
    coordinates = [0.0] * 6 + [*displacements.ravel()]
    radii = [1.0] + [RADIUS_RATIO] * (1 + len(displacements))
    return freesasa.calcCoord(coordinates, radii, parameters).atomArea(0) / (4 * numpy.pi)


def choose(sample, labelled, generator):
    """Some particles of a sample as (name, index, lambda, its neighbors turned at random).

    Lambda does not depend on the turn, but along the axes of a lattice FreeSASA's errors add up.
    """
    state = read(sample)
    positions = vtk_to_numpy(state.GetPoints().GetData()).astype(float)
    support_radius = vtk_to_numpy(state.GetFieldData().GetArray("support_radius"))[0]
    labels = read(labelled).GetPointData()
    fractions = vtk_to_numpy(labels.GetArray("uncovered_fraction"))
    counts = vtk_to_numpy(labels.GetArray("neighbor_count"))
    surface = numpy.flatnonzero(fractions > 0)
    interior = numpy.flatnonzero(fractions == 0)
    chosen = [*one_of_each_part(surface, fractions, SURFACE_PARTICLES, generator),
              *one_of_each_part(interior, counts, INTERIOR_PARTICLES, generator)]
    return [(sample.stem, i, fractions[i],
             neighbors(positions, i, support_radius) @ random_turn(generator))
            for i in chosen]


def label_and_choose(program, folder):
    samples = sorted(pathlib.Path(folder).glob("*.vtkhdf"))
    if not samples:
        sys.exit(f"{folder}: expected samples, found none")
    generator = numpy.random.default_rng(SEED)
    with tempfile.TemporaryDirectory() as output:
        subprocess.run([program, "label", "--method", "exact", "--quiet", "-o", output, *samples], check=True)
        return [particle for sample in samples
                for particle in choose(sample, pathlib.Path(output, sample.name), generator)]


def max_difference(particles, algorithm, resolution, number):
    """Between the labels and FreeSASA; and its particle."""
    differences = [abs(area_fraction(displacements, algorithm, resolution, number) - fraction)
                   for _, _, fraction, displacements in particles]
    worst = numpy.argmax(differences)
    return differences[worst], particles[worst]


def main():
    particles = label_and_choose(*sys.argv[1:])
    uncovered = sum(fraction > 0 for _, _, fraction, _ in particles)
    print(f"{len(particles)} particles, lambda > 0 for {uncovered} of them")
    failed = False
    for algorithm, (resolution, numbers, tolerance) in ALGORITHMS.items():
        for number in numbers:
            difference, (name, i, fraction, _) = max_difference(particles, algorithm, resolution, number)
            failed = failed or not difference < tolerance(number)
            print(f"{algorithm}, {number} {resolution[2:]}: largest difference {difference:.1e}, tolerance "
                  f"{tolerance(number):.1e} (particle {i} of {name}, lambda {fraction:.9f})", flush=True)
    if failed:
        sys.exit("lambda differs from FreeSASA's by more than FreeSASA's own error")


main()
