#!/usr/bin/env bash
# Builds the same commit in two folders, and compares what comes out byte by byte:
#
#     scripts/check_reproducible.sh [TARGET...]
#
# by default the C library and the command, without the libtorch module, tests and benchmarks. The two
# lie in folders of paths of different length, with all they need. Exit status 1 where something
# differs.
set -euo pipefail
cd "$(dirname "$0")/.."
targets=("$@")
[ ${#targets[@]} -gt 0 ] || targets=(meniscus_c meniscus)

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
copies=("$work/a" "$work/another/folder/of/another/length")
for copy in "${copies[@]}"; do
    git clone --quiet --shared . "$copy"
    cmake -S "$copy" -B "$copy/build" -G Ninja -DCMAKE_UNITY_BUILD=ON -DMENISCUS_TESTS=OFF \
        -DMENISCUS_BENCHMARKS=OFF -DMENISCUS_PYTHON=OFF -DMENISCUS_TRAINER=OFF >/dev/null
    cmake --build "$copy/build" --target "${targets[@]}" >"$work/build.log" || {
        cat "$work/build.log" >&2
        exit 1
    }
done

differ=0
while read -r file; do
    if cmp -s "${copies[0]}/build/$file" "${copies[1]}/build/$file"; then
        echo "same: $file $(sha256sum <"${copies[0]}/build/$file" | cut -c1-16)"
    else
        echo "DIFFERS: $file"
        differ=1
    fi
done < <(cd "${copies[0]}/build" && find . -type f \( -path './bin/*' -o -name '*.so.*' -o -name '*.a' \) | sort)
exit $differ
