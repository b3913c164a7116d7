#!/usr/bin/env bash
# Prints the tables of README and docs/ again from the samples, between their "begin" and "end"
# comments, and draws the plots. Takes some minutes, curvature half an hour; speed,
# speed-against-error, surface-speed and step-speed want an otherwise idle machine, sampling and
# normals Debian's python3-matplotlib.
# Usage: scripts/update_docs.sh [TABLES]   (default: all)
# TABLES: accuracy, own-scenes (runs scenes for some ten minutes), speed, sampling, force,
# surface-speed, normals, curvature, scenes, simulation, step-speed, hard-cases, hard-cases-solvers or
# speed-against-error (runs scenes, too)
set -euo pipefail
cd "$(dirname "$0")/.."
bin=build/release/bin
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

# replace FILE NAME < TEXT: the lines between the comments of that name.
replace() {
    cat >"$work/text"
    awk -v name="$2" -v text="$work/text" '
        $0 == "<!-- end " name " -->" { while ((getline line <text) > 0) print line; inside = 0 }
        !inside { print }
        $0 == "<!-- begin " name " -->" { inside = 1 }' "$1" >"$work/new"
    cp "$work/new" "$1"
}

what=${1:-all}
wanted() {
    [ "$what" = all ] || [ "$what" = "$1" ]
}

if wanted accuracy || wanted speed; then
    "$bin/meniscus" label data/samples/*.vtkhdf -o "$work/labelled" --quiet
fi
if wanted accuracy; then
    for table in training unseen published sweep own-line; do
        "$bin/accuracy_tables" "$table" "$work"/labelled/*.vtkhdf | replace docs/accuracy.md "$table"
    done
fi
if wanted own-scenes; then
    "$bin/meniscus" label data/samples/*.vtkhdf -o "$work/samples" --quiet
    for kind in training_3d audit_{3d,2d,wide_3d,wide_2d}; do
        scripts/make_states.sh "$kind" "$work/$kind"
    done
    "$bin/accuracy_tables" sources "$work"/samples/*.vtkhdf -- "$work"/training_3d/*.vtkhdf -- \
        "$work"/audit_3d/*.vtkhdf | replace docs/accuracy.md sources
    "$bin/accuracy_tables" readme "$work"/samples/*.vtkhdf -- "$work"/training_3d/*.vtkhdf |
        replace README.md readme
    models=configs/models/surface
    "$bin/accuracy_tables" lines "$models"_3d.json "$models"_3d_strict.json \
        "$models"_3d_relative.json -- "$work"/audit_3d/*.vtkhdf | replace docs/accuracy.md own-3d
    "$bin/accuracy_tables" lines "$models"_3d.json "$models"_3d_wide.json -- \
        "$work"/audit_wide_3d/*.vtkhdf | replace docs/accuracy.md own-wide-3d
    "$bin/accuracy_tables" lines "$models"_3d.json "$models"_2d.json -- \
        "$work"/audit_2d/*.vtkhdf | replace docs/accuracy.md own-2d
    "$bin/accuracy_tables" lines "$models"_2d.json "$models"_2d_wide.json -- \
        "$work"/audit_wide_2d/*.vtkhdf | replace docs/accuracy.md own-wide-2d
fi
if wanted speed; then
    "$bin/speed" data/samples/dam_dfsph_14.vtkhdf 2>/dev/null | replace docs/speed.md speed
    "$bin/label_speed" data/samples/{dam_dfsph_14,crown_dfsph_15,droplet_iisph_14}.vtkhdf 2>/dev/null |
        replace docs/speed.md label-speed
    "$bin/label_scaling" data/samples/dam_dfsph_14.vtkhdf | replace docs/speed.md label-scaling
    "$bin/training_time" "$work"/labelled/*.vtkhdf | replace docs/speed.md training-time
fi
if wanted sampling; then
    "$bin/sampling_schemes" "$work/schemes.json" data/samples/*.vtkhdf |
        replace docs/sampling_schemes.md sampling-schemes
    scripts/plot_sampling_schemes.py "$work/schemes.json" docs/plots
fi
if wanted force; then
    "$bin/force_accuracy" young_laplace | replace docs/surface_tension.md young-laplace
    "$bin/force_accuracy" fade data/samples/{droplet_iisph_14,cube_iisph_05,crown_dfsph_15,dam_dfsph_14}.vtkhdf |
        replace docs/surface_tension.md fade
    "$bin/force_accuracy" momentum data/samples/{droplet_iisph_14,cube_iisph_05}.vtkhdf |
        replace docs/surface_tension.md momentum
fi
if wanted surface-speed; then
    for build in surface_speed surface_speed_native; do
        "$bin/$build" data/samples/{dam_dfsph_14,crown_dfsph_15}.vtkhdf 2>/dev/null |
            replace docs/surface_tension.md "${build//_/-}"
    done
fi
if wanted normals; then
    for table in circle schemes smoothing; do
        "$bin/normal_accuracy" "$table" | replace docs/normals.md "$table"
    done
    "$bin/normal_accuracy" time "$work/normals.json" | replace docs/normals.md time
    scripts/plot_normals.py "$work/normals.json" docs/plots
    "$bin/normal_accuracy" ratio data/samples/droplet_iisph_14.vtkhdf |
        replace docs/normals.md ratio
fi
if wanted curvature; then
    "$bin/curvature_accuracy" ablation configs/curvature/solver_like_3d.json |
        replace docs/curvature.md curvature-ablation
    "$bin/curvature_accuracy" filled | replace docs/curvature.md curvature-filled
    "$bin/curvature_accuracy" circles | replace docs/curvature.md curvature-circles
    "$bin/curvature_accuracy" ellipsoid configs/models/curvature_dense_3d.json |
        replace docs/curvature.md curvature-ellipsoid
    "$bin/curvature_accuracy" droplet data/samples/cube_iisph_05.vtkhdf |
        replace docs/curvature.md curvature-droplet
fi
if wanted scenes; then
    "$bin/scene_table" configs/scenes/*.json | replace docs/scenes.md scenes
fi
if wanted simulation; then
    for table in runs dam_front iterations; do
        "$bin/solver_runs" "$table" configs/scenes | replace docs/simulation.md "${table//_/-}"
    done
    for table in formation formation_paper line rivals coalescence oscillation; do
        "$bin/droplets" "$table" configs/scenes | replace docs/simulation.md "${table//_/-}"
    done
fi
if wanted step-speed; then
    for table in stages scaling; do
        "$bin/step_speed" "$table" configs/scenes | replace docs/simulation.md "$table"
    done
fi
if wanted speed-against-error; then
    page=docs/speed_against_error.md
    scripts/bench.sh -o "$work/bench"
    bench=build/bench/bin/meniscus
    for table in machine detectors_3d features_3d{,_2_percent} coverage_estimators line_shift \
        tension_steps; do
        sed 's#](\([a-z0-9_]*\.svg\))#](plots/\1)#' "$work/bench/$table.md" |
            replace "$page" "${table//_/-}"
    done
    cp "$work"/bench/*.svg docs/plots
    # Detectors on states that no line has seen, and on the scene that the paper compares itself on.
    scripts/make_states.sh audit_3d "$work/unseen_3d" "$bench"
    scripts/make_states.sh audit_2d "$work/unseen_2d" "$bench"
    scripts/make_states.sh audit_double_dam "$work/double_dam" "$bench"
    for states in unseen_3d unseen_2d double_dam; do
        "$bench" bench "$work/$states"/*.vtkhdf -o "$work/bench_$states" --tables detectors \
            --repetitions 5
        grep -v '^!\[' "$work/bench_$states"/detectors_?d.md | replace "$page" "${states//_/-}"
    done
    # Features on all that the shipped line is trained on.
    scripts/make_states.sh training_3d "$work/training" "$bench"
    "$bench" bench data/samples/*.vtkhdf "$work"/training/*.vtkhdf -o "$work/bench_training" \
        --tables features --repetitions 5
    grep -v '^!\[' "$work/bench_training/features_3d_2_percent.md" | replace "$page" own-features
fi
if wanted hard-cases; then
    "$bin/hard_cases_table" | replace docs/hard_cases.md hard-cases
    {
        echo "| arithmetic | particles | changed by coverage | lambda up to | changed by the line |" \
            "from the line up to | largest error of lambda | outside |"
        echo "|---|---|---|---|---|---|---|---|"
        "$bin/rounding_table" "plain" data/samples
        "$bin/rounding_table_native" "-march=native -ffp-contract=fast" data/samples
        "$bin/rounding_table_fast_math" "-ffast-math" data/samples
        "$bin/rounding_table_native_fast_math" "-march=native -ffast-math" data/samples
    } | replace docs/hard_cases.md rounding
fi
if wanted hard-cases-solvers; then
    "$bin/hard_cases_solver_table" | replace docs/hard_cases.md hard-cases-solvers
fi
