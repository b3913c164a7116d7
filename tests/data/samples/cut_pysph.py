"""Cuts a file of PySPH down to every n-th particle, with all else as PySPH wrote it:

    cut_pysph.py dam_break_2d_04000.hdf5 400 pysph_dam_break.hdf5
"""
import sys

import h5py


def cut(source, target, step):
    for name, value in source.attrs.items():
        target.attrs.create(name, value, dtype=source.attrs.get_id(name).dtype)
    for name, entry in source.items():
        if isinstance(entry, h5py.Group):
            cut(entry, target.create_group(name), step)
        elif len(entry) > 0 or name in ("arho", "rho0"):  # of the properties not stored, some
            kept = target.create_dataset(name, data=entry[::step])
            for key, value in entry.attrs.items():
                kept.attrs[key] = value


with h5py.File(sys.argv[1]) as source, h5py.File(sys.argv[3], "w") as target:
    cut(source, target, int(sys.argv[2]))
