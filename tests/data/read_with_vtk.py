"""Opens the files of write_sample_snapshots with VTK's own reader and compares every value.

Arguments: the program write_sample_snapshots, and a folder for its files.
"""
import subprocess
import sys

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOHDF import vtkHDFReader
    import numpy
except ImportError as error:
    sys.exit(f"VTK's Python module or NumPy is missing ({error}); on Debian: apt-get install python3-vtk9 python3-numpy")

POINT_DATA = {
    "int8": numpy.int8, "uint8": numpy.uint8, "int16": numpy.int16, "uint16": numpy.uint16,
    "int32": numpy.int32, "uint32": numpy.uint32, "int64": numpy.int64, "uint64": numpy.uint64,
    "Surf.Class_(SurfZR20)": numpy.float32, "uncovered_fraction": numpy.float64,
    "velocity": numpy.float32,
}


def expected(particles, components, number_type):
    values = 10 * numpy.arange(particles)[:, None] + numpy.arange(components)
    # Through uint64, so that small types wrap around as they do in C++.
    values = values.astype(numpy.uint64).astype(number_type)
    return values[:, 0] if components == 1 else values


def compare(what, found, wanted):
    found = vtk_to_numpy(found)
    if found.dtype.kind != wanted.dtype.kind or found.dtype.itemsize != wanted.dtype.itemsize:
        sys.exit(f"{what}: expected type {wanted.dtype}, found {found.dtype}")
    if found.shape != wanted.shape or not (found == wanted).all():
        sys.exit(f"{what}: expected {wanted}, found {found}")


def check_particles(path, grid, particles, dimension):
    points = expected(particles, 3, numpy.float32 if dimension == 2 else numpy.float64)
    if dimension == 2:
        points[:, 2] = 0
    compare(f"{path}: points", grid.GetPoints().GetData(), points)
    if any(grid.GetCellType(i) != 1 for i in range(particles)):
        sys.exit(f"{path}: expected vertex cells")
    if any(grid.GetCell(i).GetPointId(0) != i for i in range(particles)):
        sys.exit(f"{path}: expected cell i to hold point i")

    point_data = grid.GetPointData()
    found = {point_data.GetArrayName(i) for i in range(point_data.GetNumberOfArrays())}
    if found != set(POINT_DATA):
        sys.exit(f"{path}: expected point data {sorted(POINT_DATA)}, found {sorted(found)}")
    for name, number_type in POINT_DATA.items():
        compare(f"{path}: {name}", point_data.GetArray(name),
                expected(particles, 3 if name == "velocity" else 1, number_type))


def check(path, particles, dimension):
    reader = vtkHDFReader()
    if not reader.CanReadFile(path):
        sys.exit(f"{path}: VTK says that it cannot read it")
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    if grid is None or grid.GetNumberOfPoints() != particles or grid.GetNumberOfCells() != particles:
        sys.exit(f"{path}: expected {particles} points and cells, found {grid}")

    if particles > 0:  # otherwise VTK makes no arrays
        check_particles(path, grid, particles, dimension)

    fields = {"support_radius": 0.08, "particle_spacing": 0.04, "time": 0.3}
    for name, value in fields.items():
        compare(f"{path}: {name}", grid.GetFieldData().GetArray(name), numpy.array([value]))
    compare(f"{path}: dimension", grid.GetFieldData().GetArray("dimension"),
            numpy.array([dimension], dtype=numpy.int32))


def main():
    program, folder = sys.argv[1:]
    subprocess.run([program, folder], check=True)
    for particles in (0, 1, 12, 20000):
        for dimension in (2, 3):
            check(f"{folder}/{dimension}d_{particles}.vtkhdf", particles, dimension)


main()
