#!/usr/bin/env bash
# Trains the lines that ship with the project on its samples and exports their headers. For whoever
# changes the samples, the labels or the training: scripts/train_shipped_models.sh [MENISCUS]
set -euo pipefail
cd "$(dirname "$0")/.."
meniscus=${1:-build/release/bin/meniscus}
labelled=$(mktemp -d)
trap 'rm -r "$labelled"' EXIT
"$meniscus" label data/samples/*.vtkhdf -o "$labelled" --quiet

# ship MODEL HEADER STRUCT [OPTIONS OF TRAIN]
ship() {
    "$meniscus" train "$labelled"/*.vtkhdf -o "configs/models/$1.json" "${@:4}"
    "$meniscus" export "configs/models/$1.json" -o "runtime/$2.hpp" --name "$3" --quiet
}
ship surface_3d surface_coefficients SurfaceCoefficients --label-threshold 0.02
ship surface_3d_strict strict_surface_coefficients StrictSurfaceCoefficients --label-threshold 0
ship surface_3d_relative relative_surface_coefficients RelativeSurfaceCoefficients \
    --label-threshold 0.02 --relative-count
