#!/usr/bin/env python3
"""Trains a line on all snapshots but the last, and shows on that one what moving the line up or down
does: false negatives for false positives.

Usage: 02_train_and_move_d.py SNAPSHOT SNAPSHOT...
"""
import sys

import meniscus

states = [meniscus.label(meniscus.read(file)).snapshot for file in sys.argv[1:]]
line = meniscus.Line.train(states[:-1], label_threshold=0.02)
print(line)
for by in (-4, -2, -1, 0, 1, 2, 4):
    found = line.moved(by).audit(states[-1:])["total"]
    print(f"d {by:+}: {found['false_negatives']} missed, {found['false_positives']} false positives "
          f"of {found['particles']}")
