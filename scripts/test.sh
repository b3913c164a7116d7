#!/usr/bin/env bash
# From a fresh clone to passed tests: installs what is missing, builds, and runs the default tests.
# Goes on from what scripts/demo.sh has built.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
options=()
[ -e build/release/build.ninja ] || options=(-DCMAKE_UNITY_BUILD=ON)
cmake --preset release "${options[@]}" -DMENISCUS_TESTS=ON -DMENISCUS_BENCHMARKS=ON
cmake --build --preset release
ctest --preset release --parallel "$(nproc)"
