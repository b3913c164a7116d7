#!/usr/bin/env bash
# From a fresh clone to passed tests: installs what is missing, builds, and runs the default tests.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
cmake --preset release
cmake --build --preset release
ctest --preset release --parallel "$(nproc)"
