#!/usr/bin/env bash
# From a fresh clone to the main job: installs what is missing, builds, and runs the whole chain on
# the snapshots that ship with the project. Builds in the folder of scripts/test.sh, which goes on
# from there; where that has built already, nothing is left to do.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh build
options=()
[ -e build/release/build.ninja ] || options=(-DCMAKE_UNITY_BUILD=ON -DMENISCUS_TESTS=OFF -DMENISCUS_BENCHMARKS=OFF)
cmake --preset release "${options[@]}"
cmake --build --preset release --target meniscus
build/release/bin/meniscus demo "$@"
