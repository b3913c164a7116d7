#!/usr/bin/env bash
# docs/data/series.md, as Markdown: seconds that label, audit and classify take for many frames of
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

# measure NAME VERB OPTIONS...: on the clock, and of all processors together.
measure() {
    local name=$1 TIMEFORMAT='%R %U %S'
    shift
    { time "$meniscus" "$@" --threads "$threads" --quiet 2>&3; } 3>&2 2>"$folder/time"
    awk -v name="$name" -v frames="$frames" '{ printf "| %s | %.1f | %.1f | %.1f |\n",
        name, $1, $2 + $3, 1000 * ($2 + $3) / frames }' "$folder/time"
}

echo "$frames frames, $threads thread(s), load of the machine before: $(cut -d' ' -f1 /proc/loadavg)"
echo
echo "| verb | seconds | of processors | ms of processors a frame |"
echo "|---|---|---|---|"
measure "\`label\`" label "$folder/frames" -o "$folder/labelled"
measure "\`label\`, all up to date" label "$folder/frames" -o "$folder/labelled"
measure "\`audit\`" audit "$folder/labelled"
measure "\`classify\`" classify "$folder/frames" -o "$folder/classified"
measure "\`classify\`, all up to date" classify "$folder/frames" -o "$folder/classified"
