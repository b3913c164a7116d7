#!/usr/bin/env bash
# Builds and runs the tests that concern them under sanitizers, and says how many there were:
#
#     scripts/sanitize.sh memory|threads [TARGET...]
#
# memory: addresses and undefined behavior, over the hard cases, those of the solvers too, and the
# command's tests. threads: the thread sanitizer of clang, with its OpenMP and archer (Debian's
# libomp-dev), over runtime, labeler, the four solvers, and hosts of the C interface that call from
# several threads. Builds in build/sanitize and build/thread-sanitize. Exit status 1 where a test or
# a sanitizer finds something.
set -euo pipefail
cd "$(dirname "$0")/.."

case ${1:-} in
memory)
    preset=sanitize
    targets=(hard_cases_test hard_cases_solver_test app_test)
    export UBSAN_OPTIONS=print_stacktrace=1
    ;;
threads)
    preset=thread-sanitize
    targets=(runtime_openmp_test labeler_test hard_cases_solver_test c_hosts_test)
    # Archer tells the sanitizer what OpenMP's own synchronization means; what is not compiled for it
    # (libomp itself) is left out.
    export TSAN_OPTIONS="ignore_noninstrumented_modules=1 halt_on_error=1 die_after_fork=0"
    OMP_TOOL_LIBRARIES=$(realpath -m "$(clang++ -print-resource-dir)/../../libarcher.so")
    [ -e "$OMP_TOOL_LIBRARIES" ] || {
        echo "sanitize.sh: $OMP_TOOL_LIBRARIES is missing; install Debian's package libomp-dev" >&2
        exit 2
    }
    export OMP_TOOL_LIBRARIES
    export GTEST_FILTER=-HostInput.SizesThatOverflow # the sanitizer ends where memory is refused
    ;;
*)
    sed -n '2,12s/^# \?//p' "$0" >&2
    exit 2
    ;;
esac
[ $# -eq 1 ] || targets=("${@:2}")

folder=build/$preset
[ -e "$folder/build.ninja" ] || cmake --preset "$preset" -DCMAKE_UNITY_BUILD=ON
cmake --build "$folder" --target "${targets[@]}"

failures=0
for target in "${targets[@]}"; do
    "$folder/bin/$target" >"$folder/$target.log" 2>&1 || {
        failures=$((failures + 1))
        tail -n 40 "$folder/$target.log"
    }
    echo "$target: $(grep -E '^\[  (PASSED|FAILED)' "$folder/$target.log" | head -n 2 | tr '\n' ' ')"
done
[ "$failures" -eq 0 ]
