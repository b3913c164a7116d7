"""Cuts a file of Partio with the attributes id, velocity and density, as SPlisHSPlasH writes it,
down to every n-th particle, with all else as Partio wrote it:

    cut_bgeo.py cube_iisph_partio.bgeo 200 partio_cube.bgeo
"""
import gzip
import struct
import sys

with gzip.open(sys.argv[1]) as source:
    whole = source.read()
points = struct.unpack(">I", whole[9:13])[0]
size = 4 * (4 + 1 + 3 + 1)
begin = whole.index(b"density") + len("density") + 2 + 4 + 4
kept = b"".join(whole[i : i + size] for i in range(begin, begin + points * size, int(sys.argv[2]) * size))
cut = whole[:9] + struct.pack(">I", len(kept) // size) + whole[13:begin] + kept + whole[begin + points * size :]
with open(sys.argv[3], "wb") as target:
    target.write(gzip.compress(cut, mtime=0))
