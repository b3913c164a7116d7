#!/usr/bin/env bash
# What docs/speed.md says of series: seconds that label, audit and classify take for many frames of
# 8,192 particles, and label and classify once more, which find everything up to date.
# Usage: scripts/measure_series.sh MENISCUS [FRAMES [THREADS]]
set -euo pipefail
meniscus=$1 frames=${2:-1000} threads=${3:-2}
cd "$(dirname "$0")/.."
folder=$(mktemp -d)
trap 'rm -r "$folder"' EXIT

mkdir "$folder/frames"
for ((i = 0; i < frames; ++i)); do
    cp data/samples/droplet_iisph_14.vtkhdf "$folder/frames/droplet_$i.vtkhdf"
done

# measure NAME VERB OPTIONS...
measure() {
    local name=$1 begin end
    shift
    begin=$(date +%s.%N)
    "$meniscus" "$@" --threads "$threads" --quiet
    end=$(date +%s.%N)
    awk -v name="$name" "BEGIN { printf \"%-14s %7.1f s, %6.1f ms a frame\n\", name, $end - $begin, 1000 * ($end - $begin) / $frames }"
}

echo "$frames frames, $threads thread(s)"
measure label label "$folder/frames" -o "$folder/labelled"
measure "label again" label "$folder/frames" -o "$folder/labelled"
measure audit audit "$folder/labelled"
measure classify classify "$folder/frames" -o "$folder/classified"
measure "classify again" classify "$folder/frames" -o "$folder/classified"
