#!/usr/bin/env bash
# From a fresh clone to speed against error on this machine: installs what is missing, builds, and
# runs `meniscus bench`, whose options this takes. Builds in a folder of its own, because all that it
# compares is compiled for this machine. Wants an otherwise idle one.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh bench
cmake --preset release -DMENISCUS_TESTS=OFF -DMENISCUS_BENCH_NATIVE=ON -B build/bench
cmake --build build/bench --target meniscus
build/bench/bin/meniscus bench "$@"
