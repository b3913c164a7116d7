#!/usr/bin/python3
"""Runs the commands of a page, those in its blocks marked `sh`, in the page's order in a new folder. Where
a block marked `text` follows, its lines must be among those that the commands print.

Usage: run_page.py PAGE FOLDER PROGRAM FRAMES

FOLDER is emptied first. PROGRAM is the command `meniscus`. Before, the folder gets what readers have:
`out/` and `DamBreak/` with the SPlisHSPlasH samples among FRAMES as legacy VTK files. Exit status 77 where VTK's
Python module is missing.
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

try:
    from vtkmodules.vtkIOHDF import vtkHDFReader
    from vtkmodules.vtkIOLegacy import vtkUnstructuredGridWriter
except ImportError as error:
    print(f"skipped: VTK's Python module is missing ({error})")
    sys.exit(77)


def blocks(page):
    """Commands, and what they are said to print, perhaps nothing."""
    form = r"^```sh\n(.*?)^```\n(?:```text\n(.*?)^```\n)?"
    return re.findall(form, page.read_text(), re.MULTILINE | re.DOTALL)


def run(commands, expected, folder, path):
    """Ends the program where a command fails or does not print what is expected."""
    print(commands, flush=True)
    ended = subprocess.run(["bash", "-euo", "pipefail", "-c", commands], cwd=folder, check=False,
                           env={**os.environ, "PATH": path}, stdout=subprocess.PIPE, text=True)
    print(ended.stdout, flush=True)
    missing = set(expected.splitlines()) - set(ended.stdout.splitlines())
    if ended.returncode or missing:
        sys.exit("\n".join([f"status {ended.returncode}", *(f"not printed: {line}" for line in missing)]))


def write_frames(samples, folder):
    """Samples as frames of a folder, named as SPlisHSPlasH names them."""
    folder.mkdir()
    for sample in samples:
        reader = vtkHDFReader()
        reader.SetFileName(str(sample))
        reader.Update()
        particles = reader.GetOutput()
        particles.GetFieldData().Initialize()
        for name in [particles.GetPointData().GetArrayName(k)
                     for k in range(particles.GetPointData().GetNumberOfArrays())]:
            if name not in ("velocity", "id"):
                particles.GetPointData().RemoveArray(name)
        writer = vtkUnstructuredGridWriter()
        number = int(sample.stem.rsplit("_", 1)[1])
        writer.SetFileName(str(folder / f"ParticleData_Fluid_{number}.vtk"))
        writer.SetFileTypeToBinary()
        writer.SetInputData(particles)
        writer.Write()


def main(page, folder, program, frames):
    found = blocks(Path(page))
    if not found:
        sys.exit(f"{page}: no commands")
    folder = Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name in ("out", "DamBreak"):
        write_frames(sorted(Path(frames).glob("dam_dfsph_*.vtkhdf")), folder / name)
    path = f"{Path(program).resolve().parent}:{os.environ['PATH']}"
    for commands, expected in found:
        run(commands, expected, folder, path)


if len(sys.argv) != 5:
    sys.exit(__doc__)
main(*sys.argv[1:])
