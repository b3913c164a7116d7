#!/usr/bin/env bash
# Prints the tables of README and docs/ again from the samples, between their "begin" and "end"
# comments, and draws the plots. Takes some minutes, curvature half an hour; speed,
# speed-against-error, surface-speed and step-speed want an otherwise idle machine, accuracy,
# sampling and normals Debian's python3-matplotlib, accuracy python3-h5py, too.
# Usage: scripts/update_docs.sh [TABLES]   (default: all)
# TABLES: accuracy, own-scenes (runs scenes for some ten minutes), speed, sampling, force,
# detectors, surface-speed, normals, curvature, scenes, simulation, studies, contact-angles, step-speed, hard-cases, hard-cases-solvers or
# speed-against-error (runs scenes, too)
set -euo pipefail
cd "$(dirname "$0")/.."
bin=build/release/bin
cmake --build build/release --target meniscus meniscus_bench meniscus_bench_native
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

# print TABLE PAGE [NAME] [FILES...]: what meniscus_bench prints, between the comments of that name.
print() {
    "$bin/meniscus_bench" "$1" "${@:4}" | replace "docs/$2.md" "${3:-$1}"
}

samples=data/samples
if wanted accuracy || wanted own-scenes || wanted speed || wanted detectors; then
    "$bin/meniscus" label $samples/*.vtkhdf -o "$work/samples" --features direction_eigenvalue --quiet
fi
if wanted accuracy; then
    for table in training unseen published sweep own-line; do
        print $table accuracy "" "$work"/samples/*.vtkhdf
    done
    scripts/plot_feature_planes.py configs/models/surface_3d.json docs/plots \
        "$work"/samples/dam_dfsph_{01,04,14}.vtkhdf
fi
if wanted detectors; then
    print detector-thresholds detectors "" "$work"/samples/*.vtkhdf
fi
if wanted own-scenes; then
    for kind in training_3d audit_{,wide_,widest_}{3d,2d}; do
        scripts/make_states.sh "$kind" "$work/$kind"
    done
    print sources accuracy "" "$work"/{samples,training_3d,audit_3d}
    "$bin/meniscus_bench" readme "$work"/{samples,training_3d} | replace README.md readme
    models=configs/models/surface
    print lines accuracy own-3d ${models}_3d{,_strict}.json "$work"/audit_3d/*.vtkhdf
    print lines accuracy own-wide-3d ${models}_3d_wide.json "$work"/audit_wide_3d/*.vtkhdf
    print lines accuracy own-widest-3d ${models}_3d_widest.json "$work"/audit_widest_3d/*.vtkhdf
    print lines accuracy own-2d ${models}_2d.json "$work"/audit_2d/*.vtkhdf
    print lines accuracy own-wide-2d ${models}_2d_wide.json "$work"/audit_wide_2d/*.vtkhdf
    print lines accuracy own-widest-2d ${models}_2d_widest.json "$work"/audit_widest_2d/*.vtkhdf
fi
if wanted speed; then
    print speed speed "" $samples/dam_dfsph_14.vtkhdf
    print label-speed speed "" $samples/{dam_dfsph_14,crown_dfsph_15,droplet_iisph_14}.vtkhdf
    print label-scaling speed "" $samples/dam_dfsph_14.vtkhdf --threads 1
    print training-time speed "" "$work"/samples/*.vtkhdf
fi
if wanted sampling; then
    print sampling-schemes sampling_schemes "" $samples/*.vtkhdf --json "$work/schemes.json"
    scripts/plot_sampling_schemes.py "$work/schemes.json" docs/plots
fi
if wanted force; then
    print young-laplace surface_tension
    print fade surface_tension "" \
        $samples/{droplet_iisph_14,cube_iisph_05,crown_dfsph_15,dam_dfsph_14}.vtkhdf
    print momentum surface_tension "" $samples/{droplet_iisph_14,cube_iisph_05}.vtkhdf
fi
if wanted surface-speed; then
    for build in "" _native; do
        "$bin/meniscus_bench$build" surface-speed $samples/{dam_dfsph_14,crown_dfsph_15}.vtkhdf |
            replace docs/surface_tension.md "surface-speed${build//_/-}"
    done
fi
if wanted normals; then
    print normals-circle normals
    print normals-schemes normals "" --json "$work/schemes.json"
    print normals-smoothing normals
    print normals-time normals "" --json "$work/times.json"
    scripts/plot_normals.py "$work"/{schemes,times}.json docs/plots
    print normals-ratio normals "" $samples/droplet_iisph_14.vtkhdf
fi
if wanted curvature; then
    print curvature-ablation curvature "" configs/curvature/solver_like_3d.json
    print curvature-filled curvature
    print curvature-circles curvature
    print curvature-ellipsoid curvature "" configs/models/curvature_dense_3d.json
    print curvature-droplet curvature "" $samples/cube_iisph_05.vtkhdf
fi
if wanted scenes; then
    print scenes scenes "" configs/scenes/*.json
fi
if wanted simulation; then
    for table in solver-runs dam-front iterations formation formation-paper formation-line rivals \
        coalescence oscillation; do
        print $table simulation
    done
fi
if wanted studies; then # prints committed results; meniscus_study NAME --record makes them anew
    cmake --build build/release --target meniscus_study
    for result in validation/*/small.json; do
        study=$(basename "$(dirname "$result")")
        "$bin/meniscus_study" "$study" --show | replace docs/studies.md "study-${study//_/-}"
    done
fi
if wanted contact-angles; then
    print contact-angles walls
fi
if wanted step-speed; then
    print stages simulation
    print scaling simulation
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
        "$bin/rounding_table" "plain" $samples
        "$bin/rounding_table_native" "-march=native -ffp-contract=fast" $samples | tail -n +3
        "$bin/rounding_table_fast_math" "-ffast-math" $samples | tail -n +3
        "$bin/rounding_table_native_fast_math" "-march=native -ffast-math" $samples | tail -n +3
    } | replace docs/hard_cases.md rounding
fi
if wanted hard-cases-solvers; then
    "$bin/hard_cases_solver_table" | replace docs/hard_cases.md hard-cases-solvers
fi
