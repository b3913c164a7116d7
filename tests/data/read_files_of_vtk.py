"""Writes particles with VTK's own writers and compares every value with what our reader makes of
them: legacy files in ASCII and binary, unstructured grids and polydata, file versions 4.2 and 5.1,
and tables as comma-separated values.

Arguments: the program print_snapshot, and a folder for the files.
"""
import itertools
import os
import subprocess
import sys

try:
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from vtkmodules.vtkCommonCore import vtkBitArray, vtkPoints, vtkIdTypeArray
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkTable, vtkUnstructuredGrid
    from vtkmodules.vtkIOCore import vtkDelimitedTextWriter
    from vtkmodules.vtkIOLegacy import vtkPolyDataWriter, vtkUnstructuredGridWriter
    import numpy
except ImportError as error:
    sys.exit(f"VTK's Python module or NumPy is missing ({error}); on Debian: apt-get install python3-vtk9 python3-numpy")

VERTEX = 1
NUMBER_TYPES = ["i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8"]


def positions(particles, number_type):
    # Few binary digits: VTK writes six decimal ones in ASCII.
    generator = numpy.random.default_rng(particles)
    return (generator.integers(-64, 65, (particles, 3)) / 64).astype(number_type)


def vtk_array(values, name):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    return array


def ids(particles):
    array = vtkIdTypeArray()
    array.SetName("global ids")
    for i in range(particles):
        array.InsertNextValue(i)
    return array


def bits(particles):
    array = vtkBitArray()
    array.SetName("bits")
    for i in range(particles):
        array.InsertNextValue(i % 3 == 0)
    return array


def add_point_data(data, particles):
    """Adds arrays of every kind to VTK's point data; returns type, components, values by name."""
    expected = {}
    for number_type in NUMBER_TYPES:
        values = numpy.arange(particles).astype(number_type)
        if number_type[0] == "f" and particles > 3:
            values[:3] = numpy.nan, numpy.inf, -numpy.inf
        if number_type[0] == "i":
            values[-1:] = numpy.iinfo(number_type).min
        data.AddArray(vtk_array(values, number_type))
        expected[number_type] = (number_type, 1, values)
    velocity = vtk_array(positions(particles, "f4"), "velocity [m/s]")
    velocity.SetComponentName(0, "along x")
    velocity.SetComponentName(1, "along y")
    velocity.SetComponentName(2, "along z")
    data.SetVectors(velocity)
    expected["velocity [m/s]"] = ("f4", 3, positions(particles, "f4").ravel())
    surface = numpy.arange(particles).astype("u1") % 2 * 255
    data.SetScalars(vtk_array(surface, "surface"))
    expected["surface"] = ("u1", 1, surface)
    data.SetNormals(vtk_array(positions(particles, "f8"), "normals"))
    expected["normals"] = ("f8", 3, positions(particles, "f8").ravel())
    data.SetTensors(vtk_array(numpy.arange(9 * particles, dtype="f4").reshape(-1, 9), "stress"))
    expected["stress"] = ("f4", 9, numpy.arange(9 * particles))
    data.SetTCoords(vtk_array(numpy.arange(2 * particles, dtype="f4").reshape(-1, 2), "texture"))
    expected["texture"] = ("f4", 2, numpy.arange(2 * particles))
    data.SetGlobalIds(ids(particles))
    expected["global ids"] = ("i4", 1, numpy.arange(particles))  # VTK stores vtkIdType as int
    data.AddArray(bits(particles))
    expected["bits"] = ("u1", 1, numpy.arange(particles) % 3 == 0)
    return expected


def data_set(kind, particles, number_type):
    points = vtkPoints()
    points.SetData(vtk_array(positions(particles, number_type), "points"))
    cells = vtkCellArray()
    for i in range(particles):
        cells.InsertNextCell(1, [i])
    if kind == "grid":
        grid = vtkUnstructuredGrid()
        grid.SetPoints(points)
        grid.SetCells(VERTEX, cells)
        return grid
    polydata = vtkPolyData()
    polydata.SetPoints(points)
    if kind == "vertices":
        polydata.SetVerts(cells)
    return polydata


def write_legacy(path, data, version, binary):
    writer = vtkUnstructuredGridWriter() if data.IsA("vtkUnstructuredGrid") else vtkPolyDataWriter()
    writer.SetFileName(path)
    writer.SetInputData(data)
    writer.SetFileVersion(version)
    if binary:
        writer.SetFileTypeToBinary()
    else:
        writer.SetFileTypeToASCII()
    if writer.Write() != 1:
        sys.exit(f"{path}: VTK cannot write it")


def read(program, path):
    """What our reader finds: its first line, and type, components, values by name."""
    output = subprocess.run([program, path], check=True, capture_output=True, text=True).stdout
    first, *lines = output.splitlines()
    arrays = {}
    for line in lines:
        words, name = line.split("\t")
        number_type, components, *values = words.split()
        number = float if number_type[0] == "f" else int
        arrays[name] = (number_type, int(components), [number(value) for value in values])
    return first, arrays


def compare(path, found, expected):
    if set(found) != set(expected):
        sys.exit(f"{path}: expected arrays {sorted(expected)}, found {sorted(found)}")
    for name, (number_type, components, values) in expected.items():
        if found[name][:2] != (number_type, components):
            sys.exit(f"{path}: {name}: expected {number_type} x {components}, found {found[name][:2]}")
        wanted = [value.item() for value in numpy.asarray(values)]
        same = len(wanted) == len(found[name][2]) and all(
            a == b or (a != a and b != b) for a, b in zip(wanted, found[name][2]))
        if not same:
            sys.exit(f"{path}: {name}: expected {wanted}, found {found[name][2]}")


def check_legacy(program, folder):
    kinds = itertools.product(("grid", "vertices", "points"), ("f4", "f8"), (42, 51), (False, True),
                              (0, 1, 2, 100))
    for kind, number_type, version, binary, particles in kinds:
        path = f"{folder}/{kind}_{number_type}_{version}_{'binary' if binary else 'ascii'}_{particles}.vtk"
        data = data_set(kind, particles, number_type)
        expected = add_point_data(data.GetPointData(), particles) if particles > 0 else {}
        write_legacy(path, data, version, binary)
        first, found = read(program, path)
        if first != f"3 {number_type}":
            sys.exit(f"{path}: expected three dimensions and positions {number_type}, found {first}")
        expected["positions"] = ("f8", 3, positions(particles, number_type).ravel())
        compare(path, found, expected)


def check_csv(program, folder):
    path = f"{folder}/table.csv"
    columns = {"id": numpy.arange(100) * 3, "density": numpy.arange(100) / 8,
               "Points:0": positions(100, "f8")[:, 0], "Points:1": positions(100, "f8")[:, 1],
               "Points:2": positions(100, "f8")[:, 2]}
    table = vtkTable()
    for name, values in columns.items():
        table.AddColumn(vtk_array(numpy.ascontiguousarray(values), name))
    writer = vtkDelimitedTextWriter()
    writer.SetFileName(path)
    writer.SetInputData(table)
    writer.Write()
    first, found = read(program, path)
    if first != "3 f8":
        sys.exit(f"{path}: expected three dimensions and positions f8, found {first}")
    compare(path, found, {"id": ("i8", 1, columns["id"]), "density": ("f8", 1, columns["density"]),
                          "positions": ("f8", 3, positions(100, "f8").ravel())})


def main():
    program, folder = sys.argv[1:]
    os.makedirs(folder, exist_ok=True)
    check_legacy(program, folder)
    check_csv(program, folder)


main()
