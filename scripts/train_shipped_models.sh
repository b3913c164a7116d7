#!/usr/bin/env bash
# Trains the lines that ship with the project, on its samples and on states of its own scenes
# (scripts/make_states.sh, which takes some minutes), and the maps of curvature on filled clouds, and
# exports their headers. For whoever changes the samples, the scenes, the step, the labels or the
# training: scripts/train_shipped_models.sh [MENISCUS]
set -euo pipefail
cd "$(dirname "$0")/.."
meniscus=${1:-build/release/bin/meniscus}
labelled=$(mktemp -d)
trap 'rm -r "$labelled"' EXIT
"$meniscus" label data/samples/*.vtkhdf -o "$labelled/samples" --quiet
for kind in training_3d wide_training_3d training_2d wide_training_2d; do
    scripts/make_states.sh "$kind" "$labelled/$kind" "$meniscus"
done

# fit STATES MODEL [OPTIONS OF TRAIN]; STATES: one or more folders in one word
fit() {
    local files=() folder
    for folder in $1; do
        files+=("$labelled/$folder"/*.vtkhdf)
    done
    "$meniscus" train "${files[@]}" -o "configs/models/$2.json" "${@:3}"
}
# ship STATES MODEL HEADER STRUCT [OPTIONS OF TRAIN]: the same with its header
ship() {
    fit "$1" "$2" "${@:5}"
    "$meniscus" export "configs/models/$2.json" -o "runtime/$3.hpp" --name "$4" --quiet
}
ship "samples training_3d" surface_3d surface_coefficients SurfaceCoefficients --label-threshold 0.02
ship "samples training_3d" surface_3d_strict strict_surface_coefficients StrictSurfaceCoefficients \
    --label-threshold 0
ship samples surface_3d_relative relative_surface_coefficients RelativeSurfaceCoefficients \
    --label-threshold 0.02 --relative-count
ship wide_training_3d surface_3d_wide wide_surface_coefficients WideSurfaceCoefficients \
    --label-threshold 0.02
ship training_2d surface_2d surface_coefficients_2d SurfaceCoefficients2D --label-threshold 0
ship wide_training_2d surface_2d_wide wide_surface_coefficients_2d WideSurfaceCoefficients2D \
    --label-threshold 0

# The other objectives, for comparison (meniscus bench); they need libtorch.
for objective in logistic network; do
    fit "samples training_3d" "surface_3d_$objective" --label-threshold 0.02 --objective $objective
done

# ship_curvature CONFIG MODEL HEADER: maps of curvature, from clouds; needs libtorch.
ship_curvature() {
    "$meniscus" calibrate "configs/curvature/$1.json" -o "configs/models/$2.json"
    "$meniscus" export "configs/models/$2.json" -o "runtime/$3.hpp" --quiet
}
ship_curvature solver_like_3d curvature_3d curvature_coefficients
ship_curvature solver_like_2d curvature_2d curvature_coefficients_2d
"$meniscus" calibrate configs/curvature/dense_3d.json -o configs/models/curvature_dense_3d.json
