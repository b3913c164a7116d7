#!/usr/bin/env bash
# Prints the tables of README, docs/ and docs/data/ again from the samples, between their "begin" and
# "end" comments, wherever these stand, and draws the plots. Takes some minutes, curvature half an
# hour; speed, speed-against-error, surface-speed and step-speed want an otherwise idle machine.
# Usage: scripts/update_docs.sh [TABLES]   (default: all)
# TABLES: accuracy, own-scenes (runs scenes for some ten minutes), speed, series, sampling, force,
# detectors, surface-speed, normals, curvature, scenes, simulation, studies, contact-angles,
# step-speed, hard-cases, hard-cases-solvers, speed-against-error (runs scenes, too), or plots, which draws those
# that need no more than the tables. `list` prints the names of all tables, and makes none.
set -euo pipefail
cd "$(dirname "$0")/.."
bin=build/release/bin
what=${1:-all}
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

wanted() {
    [ "$what" = all ] || [ "$what" = list ] || [ "$what" = "$1" ]
}

# prepare COMMAND...: runs it, unless names are all that is wanted.
prepare() {
    [ "$what" = list ] || "$@"
}

# fill NAME COMMAND...: what the command prints, less its pictures, goes between the comments of that
# name, which one page has.
fill() {
    if [ "$what" = list ]; then
        echo "$1"
        return
    fi
    "${@:2}" >"$work/printed"
    grep -v '^!\[' "$work/printed" | cat -s >"$work/text"
    local page
    page=$(grep -lx "<!-- begin $1 -->" README.md docs/*.md docs/data/*.md)
    awk -v name="$1" -v text="$work/text" '
        $0 == "<!-- end " name " -->" { while ((getline line <text) > 0) print line; inside = 0 }
        !inside { print }
        $0 == "<!-- begin " name " -->" { inside = 1 }' "$page" >"$work/new"
    cp "$work/new" "$page"
}

# print TABLE [NAME] [FILES...]: what meniscus_bench prints.
print() {
    fill "${2:-$1}" "$bin/meniscus_bench" "$1" "${@:3}"
}

# marked NAME: the file of what stands between the comments of that name.
marked() {
    local page
    page=$(grep -lx "<!-- begin $1 -->" README.md docs/*.md docs/data/*.md)
    awk -v name="$1" '
        $0 == "<!-- end " name " -->" { inside = 0 }
        inside { print }
        $0 == "<!-- begin " name " -->" { inside = 1 }' "$page" >"$work/$1.md"
    echo "$work/$1.md"
}

# plot NAME TABLE OPTIONS...: docs/plots/NAME.svg of a table in docs/data/, or of another file.
plot() {
    local table=docs/data/$2.md
    [ -e "$table" ] || table=$2
    "$bin/meniscus" plot "$table" -o "docs/plots/$1.svg" --quiet "${@:3}"
}

prepare cmake --build build/release --target meniscus meniscus_bench meniscus_bench_native
samples=data/samples
if wanted accuracy || wanted own-scenes || wanted speed || wanted detectors; then
    prepare "$bin/meniscus" label $samples/*.vtkhdf -o "$work/samples" --quiet \
        --features direction_eigenvalue
fi
if wanted accuracy; then
    for table in training unseen published sweep own-line; do
        print $table "" "$work"/samples/*.vtkhdf
    done
    for state in dam_dfsph_{01,04,14}; do
        prepare "$bin/meniscus" plot "$work/samples/$state.vtkhdf" --model surface_3d --quiet \
            -o "docs/plots/feature_planes_$state.svg"
    done
fi
if wanted detectors; then
    print detector-thresholds "" "$work"/samples/*.vtkhdf
fi
if wanted own-scenes; then
    for kind in training_3d audit_{,wide_,widest_}{3d,2d}; do
        prepare scripts/make_states.sh "$kind" "$work/$kind"
    done
    print sources "" "$work"/{samples,training_3d,audit_3d}
    print readme "" "$work"/{samples,training_3d}
    models=configs/models/surface
    print lines own-3d ${models}_3d{,_strict}.json "$work"/audit_3d/*.vtkhdf
    print lines own-wide-3d ${models}_3d_wide.json "$work"/audit_wide_3d/*.vtkhdf
    print lines own-widest-3d ${models}_3d_widest.json "$work"/audit_widest_3d/*.vtkhdf
    print lines own-2d ${models}_2d.json "$work"/audit_2d/*.vtkhdf
    print lines own-wide-2d ${models}_2d_wide.json "$work"/audit_wide_2d/*.vtkhdf
    print lines own-widest-2d ${models}_2d_widest.json "$work"/audit_widest_2d/*.vtkhdf
fi
if wanted speed; then
    print speed "" $samples/dam_dfsph_14.vtkhdf
    print label-speed "" $samples/{dam_dfsph_14,crown_dfsph_15,droplet_iisph_14}.vtkhdf
    print label-scaling "" $samples/dam_dfsph_14.vtkhdf --threads 1
    print training-time "" "$work"/samples/*.vtkhdf
fi
if wanted series; then
    fill series scripts/measure_series.sh "$bin/meniscus"
fi
if wanted sampling; then
    print sampling-schemes "" $samples/*.vtkhdf
fi
if wanted force; then
    print young-laplace
    print fade "" \
        $samples/{droplet_iisph_14,cube_iisph_05,crown_dfsph_15,dam_dfsph_14}.vtkhdf
    print momentum "" $samples/{droplet_iisph_14,cube_iisph_05}.vtkhdf
fi
if wanted surface-speed; then
    for build in "" _native; do
        fill "surface-speed${build//_/-}" "$bin/meniscus_bench$build" surface-speed \
            $samples/{dam_dfsph_14,crown_dfsph_15}.vtkhdf
    done
fi
if wanted normals; then
    print normals-circle
    print normals-schemes
    print normals-smoothing
    print normals-time
    print normals-ratio "" $samples/droplet_iisph_14.vtkhdf
fi
if wanted curvature; then
    print curvature-ablation "" configs/curvature/solver_like_3d.json
    print curvature-filled
    print curvature-circles
    print curvature-ellipsoid "" configs/models/curvature_dense_3d.json
    print curvature-droplet "" $samples/cube_iisph_05.vtkhdf
fi
if wanted scenes; then
    print scenes "" configs/scenes/*.json
fi
if wanted simulation; then
    for table in solver-runs dam-front iterations formation formation-paper formation-line rivals \
        coalescence oscillation; do
        print $table
    done
fi
if wanted studies; then # prints committed results; meniscus study NAME --record makes them anew
    for result in validation/*/small.json; do
        study=$(basename "$(dirname "$result")")
        fill "study-${study//_/-}" "$bin/meniscus" study "$study" --show --plots docs/plots
    done
fi
if wanted contact-angles; then
    print contact-angles
fi
if wanted step-speed; then
    print stages
    print scaling
fi
if wanted speed-against-error; then
    prepare scripts/bench.sh -o "$work/bench"
    bench=build/bench/bin/meniscus
    for table in machine detectors_3d features_3d{,_2_percent} coverage_estimators line_shift \
        tension_steps; do
        fill "${table//_/-}" cat "$work/bench/$table.md"
    done
    # Detectors on states that no line has seen, and on the scene that the paper compares itself on.
    prepare scripts/make_states.sh audit_3d "$work/unseen_3d" "$bench"
    prepare scripts/make_states.sh audit_2d "$work/unseen_2d" "$bench"
    prepare scripts/make_states.sh audit_double_dam "$work/double_dam" "$bench"
    for states in unseen_3d unseen_2d double_dam; do
        prepare "$bench" bench "$work/$states"/*.vtkhdf -o "$work/bench_$states" \
            --tables detectors --repetitions 5
        fill "${states//_/-}" cat "$work/bench_$states"/detectors_?d.md
    done
    # Features on all that the shipped line is trained on.
    prepare scripts/make_states.sh training_3d "$work/training" "$bench"
    prepare "$bench" bench data/samples/*.vtkhdf "$work"/training/*.vtkhdf \
        -o "$work/bench_training" --tables features --repetitions 5
    fill own-features cat "$work/bench_training/features_3d_2_percent.md"
fi
rounding_tables() {
    "$bin/rounding_table" "plain" $samples
    "$bin/rounding_table_native" "-march=native -ffp-contract=fast" $samples | tail -n +3
    "$bin/rounding_table_fast_math" "-ffast-math" $samples | tail -n +3
    "$bin/rounding_table_native_fast_math" "-march=native -ffast-math" $samples | tail -n +3
}
if wanted hard-cases; then
    fill hard-cases "$bin/hard_cases_table"
    fill rounding rounding_tables
fi
if wanted hard-cases-solvers; then
    fill hard-cases-solvers "$bin/hard_cases_solver_table"
fi
if wanted plots && [ "$what" != list ]; then
    detectors=(--x "ns a particle, 1 thread" --names detector --series group --logarithmic xy)
    plot detectors_3d_missed detectors_3d --y "false negatives" "${detectors[@]}" \
        --title "Surface detectors in 3D: what they miss"
    plot detectors_3d_false_positives detectors_3d --y "false positives, %" "${detectors[@]}" \
        --title "Surface detectors in 3D: false positives"
    features=(--x "ns a particle" --y "false positives, %" --names features --series kind
        --logarithmic xy)
    plot features_3d features_3d "${features[@]}" --title "Everything uncovered is surface"
    plot features_3d_2_percent features_3d_2_percent "${features[@]}" \
        --title "Surface is more than 2 % uncovered"
    samples=(--x "us a surface particle, 1 thread" --series estimator --panel case --joined
        --logarithmic xy)
    plot coverage_estimators_lambda coverage_estimators --y "error of lambda" "${samples[@]}"
    plot coverage_estimators_normal coverage_estimators --y "normal, degrees" "${samples[@]}"
    plot coverage_estimators_curvature coverage_estimators --y "h kappa" "${samples[@]}"
    shift=(--x d --series line --panel state --joined)
    plot line_shift_candidates line_shift --y candidates "${shift[@]}"
    plot line_shift_false_negatives line_shift --y "false negatives" "${shift[@]}" --logarithmic y
    plot line_shift_time line_shift --y "step, ns a particle" "${shift[@]}"
    plot tension_steps tension_steps --x "ns a particle, 1 thread" \
        --y "angle to the normal, degrees" --names model --series group --panel state \
        --logarithmic xy
    plot young_laplace young_laplace --x "R / h" --y "force / (2 pi R sigma)" \
        --series arrangement --panel samples --joined
    plot curvature_filled curvature_filled --x "h kappa" --y "closed, exact" \
        --y "calibrated, exact" --series particles
    plot fade fade --x fade --y "lambda < 0.02" --series fluid --panel form --joined
    plot normals_ratio normals_ratio --x r2/r1 --y "degrees, 128 samples" \
        --y "error of h kappa, 128 samples" --series case --joined
    for quantity in error discrepancy; do
        scripts/long_tables.py sampling $quantity >"$work/sampling.md"
        plot sampling_$quantity "$work/sampling.md" --x "directions a particle" --y $quantity \
            --series scheme --panel dimension --joined --logarithmic xy
    done
    scripts/long_tables.py normals >"$work/normals.md"
    plot normals "$work/normals.md" --x "ns a surface particle" --y "mean error, degrees" \
        --series directions --panel normals --joined --logarithmic xy
    rows=(--table 1 --x "median, ms" --names benchmark --logarithmic x)
    for table in speed label_speed surface_speed; do
        plot $table $table "${rows[@]}"
    done
    plot hard_cases hard_cases --x "largest error of lambda: float" --names case --logarithmic x
    plot rivals "$(marked rivals)" --x "rms speed, m/s" --y "deviation, %" \
        --names "model and coefficient" --logarithmic x
    plot coalescence "$(marked coalescence)" --x "deviation, %" --names "model and coefficient" \
        --logarithmic x
    plot dam_front "$(marked dam-front)" --x T --joined \
        --y "measured Z,MPS,1250 particles,20000 particles"
    plot iterations "$(marked iterations)" --x "pressure iterations" --names "surface tension" \
        --series solver --panel scene
    plot step_scaling "$(marked scaling)" --x particles --joined --logarithmic x \
        --y "neighbors,density,divergence,surface tension,pressure,rest"
fi
