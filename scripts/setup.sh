#!/usr/bin/env bash
# Installs from Debian's packages what building and testing need and the machine lacks. Needs root,
# or sudo. `scripts/setup.sh build` leaves out what only benchmarks and tests need,
# `scripts/setup.sh bench` what only the tests need.
set -euo pipefail

build_packages=(
    cmake g++ ninja-build
    libcli11-dev libeigen3-dev libfmt-dev libhdf5-dev libssl-dev libtorch-dev libzstd-dev
    nlohmann-json3-dev pybind11-dev python3-dev zlib1g-dev)
bench_packages=(libbenchmark-dev libqhull-dev)
test_packages=(clang libclang-rt-dev libgtest-dev python3-numpy python3-pip python3-vtk9)

wanted=("${build_packages[@]}")
[ "${1:-all}" = build ] || wanted+=("${bench_packages[@]}")
[ "${1:-all}" != all ] || wanted+=("${test_packages[@]}")

missing=()
for package in "${wanted[@]}"; do
    dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed ||
        missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
    exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        echo "setup.sh: these packages are missing and only root can install them: ${missing[*]}" >&2
        exit 2
    fi
    as_root=(sudo)
fi
echo "Installing ${missing[*]}"
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}"
