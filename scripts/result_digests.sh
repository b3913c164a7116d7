#!/usr/bin/env bash
# Prints digests of results, to tell whether a change of the code changed one: labels of the samples
# (exact and by Monte Carlo), the lines trained on them, what `classify` finds with them, and a short
# run of each solver and of each model of surface tension. Positions, velocities, labels, classes,
# normals, curvatures and forces count; names, options and versions that are stored beside them do not.
# Usage: scripts/result_digests.sh [MENISCUS]
set -euo pipefail
meniscus=$(realpath "${1:-build/release/bin/meniscus}")
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

# values NAME FILES...: one digest over the point data of all files.
values() {
    local name=$1 file
    shift
    for file in "$@"; do
        /usr/bin/python3 scripts/snapshot_digest.py "$file"
    done | sha256sum | awk -v name="$name" '{ print substr($1, 1, 16), name }'
}

label() {
    "$meniscus" label data/samples/*.vtkhdf -o "$work/$1" --threads 1 --quiet "${@:2}"
    values "labels, $1" "$work/$1"/*.vtkhdf
}
label exact --features direction_eigenvalue
for scheme in halton blue-noise table; do
    label "$scheme" --scheme "$scheme" --samples 256
done

train() {
    "$meniscus" train "$work/exact"/*.vtkhdf -o "$work/$1.json" --quiet "${@:2}"
    grep -E '"(k|d|d_margin)":' "$work/$1.json" | sha256sum |
        awk -v name="line, $1" '{ print substr($1, 1, 16), name }'
}
train threshold_2_percent --label-threshold 0.02
train strict --label-threshold 0
train two_lines --label-threshold 0.02 --second-features mass_offset,direction_eigenvalue
train logistic --label-threshold 0.02 --objective logistic

for model in surface_3d surface_3d_strict threshold_2_percent; do
    file=configs/models/$model.json
    [ -f "$file" ] || file=$work/$model.json
    "$meniscus" classify "$work/exact"/d*_14.vtkhdf --model "$file" -o "$work/classes_$model" --threads 1 --quiet
    values "classes, $model" "$work/classes_$model"/*.vtkhdf
done

run() {
    "$meniscus" simulate "configs/scenes/$2.json" -o "$work/run_$1" --threads 1 --quiet "${@:3}"
    values "run, $1" "$work/run_$1"/*_[0-9][0-9][0-9][0-9].vtkhdf
}
short=(--duration 0.1 --set frame_interval=0.05)
run dfsph dam_break "${short[@]}"
run iisph dam_break "${short[@]}" --set pressure.solver=iisph
run pcisph dam_break "${short[@]}" --set pressure.solver=pcisph
run wcsph dam_break "${short[@]}" --set 'pressure={"solver": "wcsph", "sound_speed": 60,
    "density_error": null, "divergence_error": null}'
run dfsph_2d_double dam_break_2d "${short[@]}" --set precision=double
for model in becker_2007 huber_2015 akinci_2013 he_2014 color_field; do
    run "$model" double_droplet "${short[@]}" --set \
        "surface_tension={\"model\": \"$model\", \"coefficient\": 0.05, \"samples\": null, \
        \"balance_momentum\": null, \"k\": null, \"d\": null, \"paper\": null}"
done
run meniscus double_droplet "${short[@]}"
run meniscus_2d drop_2d "${short[@]}"
