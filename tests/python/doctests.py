#!/usr/bin/env python3
"""The examples in the docstrings of the module."""
import doctest
import importlib
import sys

import support  # noqa: F401, which leaves where NumPy is missing

MODULES = ("", ".labels", ".lines", ".simulation", ".snapshots", ".surface")

results = [doctest.testmod(importlib.import_module("meniscus" + name)) for name in MODULES]
print(sum(result.attempted for result in results), "examples")
sys.exit(any(result.failed for result in results) or not any(r.attempted for r in results))
