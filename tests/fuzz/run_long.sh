#!/usr/bin/env bash
# Long runs of the targets whose reader works in a child process (lagrangebench_fuzz,
# pysph_fuzz, vtkhdf_fuzz):
#
#     tests/fuzz/run_long.sh TARGET RUNS FOLDER
#
# libFuzzer does not see what a child does; AFL++ (Debian's afl++) does, because its map of what was
# reached is memory that children share. FOLDER keeps its state, so that a further run goes on from
# there. No sanitizers here: AddressSanitizer would switch the child's limit on memory off. After
# the runs all inputs that reached something new are read once more by the target of the build with
# sanitizers. The child's reports go to FOLDER/reports; those with code of ours on top of the stack
# are printed, and are failures. Crashes inside the HDF5 library are what the child is there for.
set -euo pipefail

[ $# -eq 3 ] || { sed -n '2,12s/^# \?//p' "$0" >&2; exit 2; }
target=$1 runs=$2 folder=$3
sources=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$folder/reports"

read -ra libraries <<<"$(pkg-config --cflags --libs hdf5 libcrypto zlib libzstd)"
mapfile -t readers < <(find "$sources/data" -name '*.cpp' ! -path '*/clouds/*' ! -path '*/samples/*' \
    ! -path '*/drawing/*')
afl-clang-fast++ -std=c++17 -O1 -g -fopenmp -fsanitize=fuzzer -I "$sources/include" \
    "$sources/tests/fuzz/$target.cpp" "${readers[@]}" "${libraries[@]}" -o "$folder/$target" \
    >"$folder/compile.log" 2>&1 || { cat "$folder/compile.log" >&2; exit 1; }

# A child may take 20 s before its limit on time ends it.
seeds=$sources/tests/fuzz/corpus/$target
[ ! -e "$folder/state/default/queue" ] || seeds=-
AFL_NO_UI=1 AFL_NO_AFFINITY=1 AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 \
    AFL_FORKSRV_INIT_TMOUT=60000 \
    afl-fuzz -i "$seeds" -o "$folder/state" -t 60000 -E "$runs" -- "$folder/$target" \
    >"$folder/afl.log" 2>&1
grep -E '^(execs_done|execs_per_sec|corpus_count|saved_crashes|saved_hangs|edges_found)' \
    "$folder/state/default/fuzzer_stats"
failures=$(find "$folder"/state/default/{crashes,hangs} -name 'id*' | wc -l)

cmake -S "$sources/tests/fuzz" -B "$folder/build" -G Ninja -DCMAKE_CXX_COMPILER=clang++ >/dev/null
cmake --build "$folder/build" --target "$target" >/dev/null
find "$folder"/state/default/queue -name 'id*' -print0 |
    ASAN_OPTIONS=log_path=$folder/reports/report:max_allocation_size_mb=1024 \
        xargs -0 -n 200 "$folder/build/$target" -rss_limit_mb=0 >"$folder/again.log" 2>&1 ||
    failures=$((failures + 1))
# The first frame of a report that is in no library.
for report in "$folder"/reports/*; do
    [ -e "$report" ] || continue
    if grep -m1 -E '^ +#[0-9]+ .* in ' <(grep -v -E 'libhdf5|sanitizer|libc\.so|asan' "$report") |
        grep -q 'meniscus::' && ! grep -q libhdf5 "$report"; then
        failures=$((failures + 1))
        cat "$report"
    fi
done
echo "$failures failures; reports of HDF5: $(find "$folder/reports" -type f | wc -l)"
[ "$failures" -eq 0 ]
