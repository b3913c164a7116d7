#!/usr/bin/env bash
# Runs scenes of configs/scenes/ and labels their frames: states that the shipped lines are trained
# on, and other ones that they are audited on.
# Usage: scripts/make_states.sh KIND FOLDER [MENISCUS]   (KIND: a function with an underscore below)
set -euo pipefail
kind=$1
folder=$(realpath -m "$2")
meniscus=$(realpath "${3:-build/release/bin/meniscus}")
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
mkdir -p "$folder"

# run SCENE NAME DURATION INTERVAL [OPTIONS OF SIMULATE]: labelled frames NAME_0000, NAME_0001, ...
# In training the scene is SCENE, so that runs of one scene weigh as much as a scene; in an audit
# each run is a row of its own. One thread: small scenes gain nothing from more.
run() {
    "$meniscus" simulate "configs/scenes/$1.json" -o "$work/$2" --set "name=$2" --duration "$3" \
        --set "frame_interval=$4" "${@:5}" --threads 1 --quiet
    local scene=()
    [[ $kind == audit_* ]] || scene=(--scene "$1")
    label_frames "$2" "$folder" "${scene[@]}"
    rm -r "${work:?}/$2"
}

# label_frames NAME FOLDER [OPTIONS OF LABEL], with the feature that second lines are of
label_frames() {
    "$meniscus" label "$work/$1"/*_[0-9][0-9][0-9][0-9].vtkhdf -o "$2" \
        --features direction_eigenvalue "${@:3}" --threads 1 --quiet
}

# run_widest SPACING and as run: the same frames with support radii of 3, 3.46 and 4.2 spacings, as
# other solvers have them. Without the walls, of which one layer does not cover what so large a
# sphere reaches behind it.
run_widest() {
    local kept=$folder
    folder=$work/raw run "${@:2}"
    mkdir -p "$work/$3"
    for frame in "$work"/raw/*.vtkhdf; do
        mv "$frame" "$work/$3/$(basename "$frame")"
    done
    folder=$kept
    for ratio in 3 3.46 4.2; do
        label_frames "$3" "$work/labelled" --scene "$2" --no-boundary \
            --support-radius "$(awk "BEGIN { print $ratio * $1 }")"
        for frame in "$work"/labelled/*.vtkhdf; do
            mv "$frame" "$folder/h${ratio}_$(basename "$frame")"
        done
    done
    rm -r "${work:?}/$3"
}

# A line that lets every particle through to the exact test: states for training must not depend on
# the line that ships.
any=(--set surface_tension.k=0 --set surface_tension.d=1000)
# Masses as in SPlisHSPlasH: about 40 neighbors inside, where whole ones give 30.
light=(--set volume_share=0.8)
iisph=(--set pressure.solver=iisph --set pressure.divergence_error=null)
pcisph=(--set pressure.solver=pcisph --set pressure.divergence_error=null)
wcsph=(--set 'pressure={"solver": "wcsph", "sound_speed": 60, "density_error": null,
    "divergence_error": null}' --set time_step.max=0.001)
fine_2d=(--set particle_spacing=0.02
    --set 'walls=[{"box": {"low": [-0.01, -0.01], "high": [4.01, 4.01]}}]')

# h = 2 spacings.
training_3d() {
    run double_droplet droplet_iisph 1.2 0.3 "${any[@]}" "${light[@]}" "${iisph[@]}"
    run drop_formation formation_dfsph 0.9 0.3 "${any[@]}" --set support_radius=0.1
    run dam_break dam_dfsph 1.2 0.15 "${any[@]}" "${light[@]}"
    run dam_break dam_iisph 1.2 0.1 "${any[@]}" "${iisph[@]}"
    run dam_break dam_wcsph 1 0.5 "${any[@]}" "${wcsph[@]}"
    run dam_break_with_obstacle obstacle_dfsph 1.2 0.2 "${any[@]}" "${light[@]}"
    run double_dam_break double_dam_pcisph 1.2 0.2 "${any[@]}" "${pcisph[@]}"
    run double_dam_break double_dam_dfsph 1.2 0.1 "${any[@]}"
    run box_with_hole hole_dfsph 1.2 0.4 "${any[@]}" "${light[@]}"
    run fluid_over_sphere sphere_dfsph 0.9 0.15 "${any[@]}"
    run crown_splash crown_dfsph 0.4 0.05 "${any[@]}" "${light[@]}"
    run crown_splash crown_iisph 0.25 0.125 "${any[@]}" "${iisph[@]}"
    run water_glass glass_dfsph 2 0.2 "${any[@]}" "${light[@]}"
    run resting_tank tank_dfsph 0.6 0.3 "${light[@]}"
}
training_2d() {
    run drop_2d drop_iisph 0.9 0.3 "${any[@]}" "${iisph[@]}"
    run drop_2d drop_light 0.9 0.3 "${any[@]}" "${light[@]}"
    run dam_break_2d dam_dfsph 1.5 0.3
    run dam_break_2d dam_light 1.2 0.3 "${light[@]}" "${iisph[@]}"
    run dam_break_2d dam_fine 1.5 0.15 "${fine_2d[@]}"
    run dam_break_2d square_pcisph 1.2 0.4 --variant square "${pcisph[@]}"
    run dam_break_2d square_fine 1.2 0.15 --variant square "${iisph[@]}" "${fine_2d[@]}"
}

# h = 2.5 spacings.
wide_training_3d() {
    run drop_formation formation_dfsph 0.9 0.3 "${any[@]}"
    run double_droplet droplet_dfsph 0.8 0.2 "${any[@]}" --set support_radius=0.2
    run double_droplet droplet_light 0.8 0.2 "${any[@]}" "${light[@]}" "${iisph[@]}" \
        --set support_radius=0.2
    run dam_break dam_dfsph 1.2 0.15 "${any[@]}" --set support_radius=0.2
    run dam_break_with_obstacle obstacle_light 1.2 0.2 "${any[@]}" "${light[@]}" \
        --set support_radius=0.2
    run double_dam_break double_dam_dfsph 1.2 0.1 "${any[@]}" --set support_radius=0.2
    run crown_splash crown_dfsph 0.3 0.1 "${any[@]}" --set support_radius=0.2
    run fluid_over_sphere sphere_dfsph 0.9 0.3 "${any[@]}" --set support_radius=0.125
}
wide_training_2d() {
    run drop_2d drop_dfsph 0.9 0.3 "${any[@]}" --set support_radius=0.0625
    run drop_2d drop_wider 0.6 0.3 "${any[@]}" --set support_radius=0.065
    run dam_break_2d dam_dfsph 1.5 0.15 --set support_radius=0.1
    run dam_break_2d dam_light 1.2 0.15 "${light[@]}" --set support_radius=0.104
    run dam_break_2d square_fine 1.2 0.15 --variant square "${iisph[@]}" "${fine_2d[@]}" \
        --set support_radius=0.05
}

# h = 3 to 4.2 spacings.
widest_training_3d() {
    run_widest 0.05 drop_formation formation_dfsph 0.9 0.3 "${any[@]}" --set support_radius=0.1
    run_widest 0.08 double_droplet droplet_light 0.8 0.4 "${any[@]}" "${light[@]}" "${iisph[@]}"
    run_widest 0.08 dam_break dam_dfsph 1.2 0.3 "${any[@]}"
    run_widest 0.08 crown_splash crown_light 0.4 0.1 "${any[@]}" "${light[@]}"
    run_widest 0.05 fluid_over_sphere sphere_dfsph 0.9 0.3 "${any[@]}"
}
widest_training_2d() {
    run_widest 0.025 drop_2d drop_light 0.9 0.3 "${any[@]}" "${light[@]}"
    run_widest 0.04 dam_break_2d dam_dfsph 1.5 0.3
    run_widest 0.02 dam_break_2d square_fine 1.2 0.15 --variant square "${iisph[@]}" "${fine_2d[@]}"
}
audit_widest_3d() {
    run_widest 0.08 double_dam_break double_dam_pcisph 1.2 0.4 "${any[@]}" "${pcisph[@]}"
    run_widest 0.08 crown_splash crown_iisph 0.3 0.1 "${any[@]}" "${iisph[@]}"
}
audit_widest_2d() {
    run_widest 0.025 drop_2d drop_iisph 0.9 0.3 "${any[@]}" "${iisph[@]}"
}

# The papers' sizes, each scene as it ships.
audit_3d() {
    run double_droplet double_droplet_paper 1 0.25 --variant paper
    run double_droplet double_droplet_splishsplash 0.7 0.35 --variant splishsplash
    run dam_break dam_break_paper 1 0.25 --variant paper
    run crown_splash crown_splash_paper 0.36 0.09 --variant paper
    run crown_splash crown_splash_light 0.36 0.09 --variant paper "${light[@]}"
    run double_dam_break double_dam_break_light 1.5 0.3 "${light[@]}"
    run water_glass water_glass_heavy 2 0.5
    run fluid_over_sphere fluid_over_sphere_light 1 0.25 "${light[@]}"
}
audit_2d() {
    run drop_2d drop_2d 2 0.5
    run drop_2d drop_2d_paper 0.15 0.05 --variant paper
    run dam_break_2d dam_break_2d_paper 1.25 0.25 --variant paper
}
audit_double_dam() {
    run double_dam_break double_dam_break 1.5 0.3
}
audit_wide_3d() {
    run drop_formation drop_formation_iisph 0.6 0.2 "${iisph[@]}"
    run crown_splash crown_splash_light 0.4 0.1 "${light[@]}" --set support_radius=0.2
    run double_dam_break double_dam_break_iisph 1 0.25 "${iisph[@]}" --set support_radius=0.2
}
audit_wide_2d() {
    run drop_2d drop_2d_iisph 1.5 0.5 "${iisph[@]}" --set support_radius=0.0625
    run dam_break_2d dam_break_2d_fine 1.5 0.25 "${fine_2d[@]}" --set support_radius=0.05
}

"$kind"
