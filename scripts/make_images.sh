#!/usr/bin/env bash
# Makes the pictures of the README in docs/images/ from the shipped samples: a cut dam by `meniscus
# picture`, and of a report's page the feature plane and the whole, by Debian's chromium.
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

sample=data/samples/dam_dfsph_08.vtkhdf
model=configs/models/surface_3d.json
"$meniscus" classify "$sample" --model "$model" -o "$work/classified" --quiet
"$meniscus" picture "$work/classified/dam_dfsph_08.vtkhdf" -o "$work/cut_dam.png" --quiet \
    --cut "z" --view 25,18 --size 900,560 --title ""
cwebp -quiet -q 86 "$work/cut_dam.png" -o "$images/cut_dam.webp"

"$meniscus" label "$work/classified/dam_dfsph_08.vtkhdf" -o "$work/labelled" --quiet
"$meniscus" audit "$work"/labelled/*.vtkhdf --model "$model" --label-threshold 0.02 --quiet \
    --report "$work/page.html"
shot feature_plane 760,655 "d=20&show=plane"
shot report_page 1400,1330 "d=20&cut=z&pick=537" # a particle at the surface
ls -l "$images"
