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
"$meniscus" label data/samples/*.vtkhdf -o "$labelled/samples" --features direction_eigenvalue --quiet
for kind in {,wide_,widest_}training_{3d,2d}; do
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
# ship STATES MODEL STRUCT [OPTIONS OF TRAIN]: the same with a second line and its header
ship() {
    fit "$1" "$2" --second-features mass_offset,direction_eigenvalue "${@:4}"
    "$meniscus" export "configs/models/$2.json" -o "runtime/coefficients/$2.hpp" --name "$3" --quiet
}
# One for each range of support radius over particle spacing (runtime/surface/shipped_classifier.hpp).
ship "samples training_3d" surface_3d Surface3D --label-threshold 0.02
ship wide_training_3d surface_3d_wide Surface3DWide --label-threshold 0.02
ship widest_training_3d surface_3d_widest Surface3DWidest --label-threshold 0.02
ship training_2d surface_2d Surface2D --label-threshold 0
ship wide_training_2d surface_2d_wide Surface2DWide --label-threshold 0
ship widest_training_2d surface_2d_widest Surface2DWidest --label-threshold 0
# And one that misses nothing at all.
ship "samples training_3d" surface_3d_strict Surface3DStrict --label-threshold 0

# The other objectives, for comparison (meniscus bench); they need libtorch.
for objective in logistic network; do
    fit "samples training_3d" "surface_3d_$objective" --label-threshold 0.02 --objective $objective
done

# ship_curvature CONFIG MODEL STRUCT: maps of curvature, from clouds; needs libtorch.
ship_curvature() {
    "$meniscus" calibrate "configs/curvature/$1.json" -o "configs/models/$2.json"
    "$meniscus" export "configs/models/$2.json" -o "runtime/coefficients/$2.hpp" --name "$3" --quiet
}
ship_curvature solver_like_3d curvature_3d Curvature3D
ship_curvature solver_like_2d curvature_2d Curvature2D
"$meniscus" calibrate configs/curvature/dense_3d.json -o configs/models/curvature_dense_3d.json
