#!/usr/bin/env python3
"""`pip install .` without an index, into an environment of its own, from where the module works."""
import importlib.util
import os
import subprocess
import sys
import tempfile
from pathlib import Path

SCRIPT = """
import meniscus, sys
assert meniscus.__file__.startswith(sys.prefix), meniscus.__file__
line = meniscus.Line.shipped(3, 2)
state = meniscus.read(sys.argv[1])
print(meniscus.__version__, meniscus.classify(state, line=line).surface.sum(), "candidates")
"""

for module, package in (("numpy", "python3-numpy"), ("pip", "python3-pip")):
    if importlib.util.find_spec(module) is None:
        print(f"skipped: {module} is missing; install Debian's {package}")
        sys.exit(77)

source = Path(os.environ["MENISCUS_SOURCE"])
with tempfile.TemporaryDirectory() as folder:
    environment = {**os.environ, "PYTHONPATH": ""}
    # System packages stand for an index: pip itself, and NumPy.
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", folder],
                   check=True)
    python = Path(folder) / "bin/python"
    subprocess.run([python, "-m", "pip", "install", "--quiet", "--no-index", "--no-build-isolation",
                    "--config-settings", f"build-folder={sys.argv[1]}", source], check=True,
                   env=environment)
    subprocess.run([python, "-c", SCRIPT, source / "data/samples/droplet_iisph_01.vtkhdf"],
                   check=True, env=environment, cwd=folder)
