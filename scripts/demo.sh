#!/usr/bin/env bash
# From a fresh clone to the main job: installs what is missing, builds, and runs the whole chain on
# the snapshots that ship with the project.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh build
cmake --preset release -DMENISCUS_TESTS=OFF -DMENISCUS_BENCHMARKS=OFF -B build/demo
cmake --build build/demo
build/demo/bin/meniscus demo "$@"
