#!/usr/bin/env bash
# Trains the lines that ship with the project on its samples and the maps of curvature on filled
# clouds, and exports their headers. For whoever
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

# ship_curvature CONFIG MODEL HEADER: maps of curvature, from clouds; needs libtorch.
ship_curvature() {
    "$meniscus" calibrate "configs/curvature/$1.json" -o "configs/models/$2.json"
    "$meniscus" export "configs/models/$2.json" -o "runtime/$3.hpp" --quiet
}
ship_curvature solver_like_3d curvature_3d curvature_coefficients
ship_curvature solver_like_2d curvature_2d curvature_coefficients_2d
"$meniscus" calibrate configs/curvature/dense_3d.json -o configs/models/curvature_dense_3d.json
