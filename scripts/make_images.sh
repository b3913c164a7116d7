#!/usr/bin/env bash
# Makes the pictures of README and docs/ in docs/images/: from the shipped samples a cut dam by `meniscus
# picture`, and of a report's page the feature plane and the whole, by Debian's chromium; what the
# commands of the tutorials draw; and the gallery of the scenes, which are run for that, some minutes.
# Usage: scripts/make_images.sh [readme|tutorials|gallery]   (default: all)
set -euo pipefail
cd "$(dirname "$0")/.."
meniscus=build/release/bin/meniscus
images=docs/images
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for needed in chromium cwebp; do
    command -v "$needed" >/dev/null || {
        echo "make_images.sh: $needed is missing; install Debian's chromium and webp" >&2
        exit 2
    }
done

# A shot of a report's page: NAME, WIDTH,HEIGHT and the fragment of the link.
shot() {
    chromium --headless --no-sandbox --hide-scrollbars --use-angle=swiftshader \
        --enable-unsafe-swiftshader --user-data-dir="$work/profile" --window-size="$2" \
        --virtual-time-budget=20000 --screenshot="$work/$1.png" "file://$work/page.html#$3" \
        2>/dev/null
    cwebp -quiet -q 82 "$work/$1.png" -o "$images/$1.webp"
}

# into NAME FILE...: pictures become NAME.webp or stay NAME.svg.
into() {
    case "$2" in
    *.svg) cp "$2" "$images/$1.svg" ;;
    *) cwebp -quiet -q 82 "$2" -o "$images/$1.webp" ;;
    esac
}

readme() {
    local sample=data/samples/dam_dfsph_08.vtkhdf model=configs/models/surface_3d.json
    "$meniscus" classify "$sample" --model "$model" -o "$work/classified" --quiet
    "$meniscus" picture "$work/classified/dam_dfsph_08.vtkhdf" -o "$work/cut_dam.png" --quiet \
        --cut "z" --view 25,18 --size 900,560 --title ""
    cwebp -quiet -q 86 "$work/cut_dam.png" -o "$images/cut_dam.webp"
    "$meniscus" label "$work/classified/dam_dfsph_08.vtkhdf" -o "$work/labelled" --quiet
    "$meniscus" audit "$work"/labelled/*.vtkhdf --model "$model" --label-threshold 0.02 --quiet \
        --report "$work/page.html"
    shot feature_plane 760,655 "d=20&show=plane"
    shot report_page 1400,1330 "d=20&cut=z&pick=537" # a particle at the surface
}

tutorials() {
    local droplet=$work/droplet dam=$work/dam
    tests/docs/run_page.py docs/tutorial_droplet.md "$droplet" "$meniscus" data/samples
    into droplet_log "$droplet/log.svg"
    into droplet_velocity "$droplet/frame.png"
    into droplet_plane "$droplet/plane.svg"
    into droplet_classes "$droplet/classes.png"
    into droplet_curvature "$droplet/curvature.png"
    tests/docs/run_page.py docs/tutorial_splishsplash.md "$dam" "$meniscus" data/samples
    into dam_label "$dam/surface.png"
    into dam_plane "$dam/plane.svg"
}

# scene NAME SECONDS OPTIONS...: its small variant after so long, as `meniscus picture` draws it.
scene() {
    "$meniscus" simulate "$1" -o "$work/$1" --quiet --set duration="$2" --set frame_interval="$2"
    "$meniscus" picture "$work/$1/$1_0001.vtkhdf" -o "$work/$1.png" --quiet --size 700,560 \
        --title "$1, $2 s" "${@:3}"
    into "scene_$1" "$work/$1.png"
}

gallery() {
    scene box_with_hole 0.5 --color velocity
    scene crown_splash 0.25 --color velocity
    scene dam_break 0.8 --color velocity
    scene dam_break_2d 0.5 --color velocity
    scene dam_break_with_obstacle 0.6 --color velocity
    scene double_dam_break 0.5 --color velocity
    scene double_droplet 0.3 --color class --cut z
    scene drop_2d 0.2 --color class
    scene drop_formation 0.3 --color mean_curvature
    scene fluid_over_sphere 0.7 --color velocity
    scene hyperbolic_paraboloid 1.5 --color class
    scene resting_tank 0.5 --color pressure
    scene water_glass 1.2 --color velocity
}

for what in readme tutorials gallery; do
    [ "${1:-$what}" != "$what" ] || "$what"
done
ls -l "$images"
