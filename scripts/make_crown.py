#!/usr/bin/env python3
"""make_crown.py FILE.npy: 128^3 particles of which a million stand in a block, 0.5 m apart, and the
rest is spray over a volume 250 times as large, all in no order: a state by which docs/cluster.md
tells how evenly slabs share the work."""

import sys

import numpy as np

if len(sys.argv) != 2:
    sys.exit(__doc__)
edge = 100
random = np.random.default_rng(1)
i = np.arange(edge**3)
x, y, z = i % edge, i // edge % edge, i // edge // edge
block = np.stack(
    [0.5 * x + 0.05 * ((3 * y + z) % 5), 0.5 * y + 0.03 * ((2 * x + z) % 7), 0.5 * z], axis=1
)
spray = random.random((128**3 - edge**3, 3)) * np.array([250, 250, 500])
everything = np.concatenate([block, spray])[random.permutation(128**3)]
np.save(sys.argv[1], everything.astype("f4"))
