"""Prints SHA-256 digests of a snapshot's points and of each of its arrays. Wants Debian's python3-h5py."""
import hashlib
import sys

import h5py

with h5py.File(sys.argv[1], "r") as file:
    group = file["VTKHDF"]
    arrays = {"Points": group["Points"], **group["PointData"]}
    for name in sorted(arrays):
        values = arrays[name][()]
        digest = hashlib.sha256(values.tobytes()).hexdigest()
        print(name, values.dtype, values.shape, digest)
