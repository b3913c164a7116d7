#!/usr/bin/env bash
# Long runs of all targets whose reader works in the process itself, one after the other:
#
#     tests/fuzz/run_all.sh SECONDS RUNS FOLDER [TARGET...]
#
# each for SECONDS or RUNS executions, whichever comes first, at the lowest priority. FOLDER/found
# keeps the inputs that reached something new, so that a further run goes on from there, FOLDER/build
# the programs, and FOLDER/table.md says how many executions there were and what they covered
# (libFuzzer's edges of the program, `cov`, and features, `ft`). Exit status 1 where one fails; its
# input lies in FOLDER. Those with a child that reads have run_long.sh.
set -euo pipefail

[ $# -ge 3 ] || { sed -n '2,11s/^# \?//p' "$0" >&2; exit 2; }
seconds=$1 runs=$2
mkdir -p "$3"
folder=$(cd "$3" && pwd)
shift 3
sources=$(cd "$(dirname "$0")" && pwd)

cmake -S "$sources" -B "$folder/build" -G Ninja -DCMAKE_CXX_COMPILER=clang++ >"$folder/build.log"
targets=("$@")
if [ ${#targets[@]} -eq 0 ]; then
    for file in "$sources"/*_fuzz.cpp; do
        grep -q run_reader_of_named_file "$file" || targets+=("$(basename "$file" .cpp)")
    done
fi
cmake --build "$folder/build" --target "${targets[@]}" >>"$folder/build.log" || {
    cat "$folder/build.log" >&2
    exit 1
}

failures=0
{
    echo '| target | executions | a second | edges covered | features | inputs kept |'
    echo '|---|---|---|---|---|---|'
} | tee "$folder/table.md"
for target in "${targets[@]}"; do
    mkdir -p "$folder/found/$target"
    log=$folder/$target.log
    nice -n 19 "$folder/build/$target" -max_total_time="$seconds" -runs="$runs" -max_len=8192 \
        -timeout=60 -rss_limit_mb=1024 -malloc_limit_mb=64 -print_final_stats=1 \
        -artifact_prefix="$folder/$target-" "$folder/found/$target" "$sources/corpus/$target" \
        >"$log" 2>&1 || { failures=$((failures + 1)); echo "$target fails: $log" >&2; }
    last=$(grep -E '^#[0-9]+.* cov: ' "$log" | tail -n 1)
    echo "| $target | $(awk '/number_of_executed_units/ { print $2 }' "$log") |" \
        "$(awk '/average_exec_per_sec/ { print $2 }' "$log") |" \
        "$(sed -E 's/.* cov: ([0-9]+).*/\1/' <<<"$last") |" \
        "$(sed -E 's/.* ft: ([0-9]+).*/\1/' <<<"$last") |" \
        "$(find "$folder/found/$target" -type f | wc -l) |" | tee -a "$folder/table.md"
done
[ "$failures" -eq 0 ]
