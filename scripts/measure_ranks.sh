#!/usr/bin/env bash
# What docs/cluster.md says of speed: one state in slabs, and files that are shared, on one process and
# on two, with the time of each, bytes exchanged and peak memory.
# Usage: scripts/measure_ranks.sh BUILD EDGE MEMORY [FOLDER]
# for a cube of EDGE^3 particles and as many again in eight files, a process having MEMORY (as 200MB).
set -euo pipefail
build=$1 edge=$2 memory=$3
folder=${4:-$(mktemp -d)}
mkdir -p "$folder"/{states,out}
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMP_NUM_THREADS=1

"$build/bin/make_block" "$edge" "$folder/block.vtkhdf"
for i in 1 2 3 4 5 6 7 8; do
    "$build/bin/make_block" $((edge / 2)) "$folder/states/block_$i.vtkhdf"
done

# measure NAME RANKS INPUT OPTIONS...
measure() {
    local name=$1 ranks=$2 begin end
    shift 2
    rm -rf "$folder/out/$name.$ranks"
    begin=$(date +%s.%N)
    mpirun --bind-to none -n "$ranks" "$build/bin/meniscus" label "$@" -o "$folder/out/$name.$ranks" |
        tail -n 1
    end=$(date +%s.%N)
    echo "$name, $ranks process(es): $(awk "BEGIN { printf \"%.1f\", $end - $begin }") s"
}

for ranks in 1 2; do
    measure slabs "$ranks" "$folder/block.vtkhdf" --memory "$memory"
    measure files "$ranks" "$folder/states"
done
cmp "$folder/out/slabs.1/block.vtkhdf" "$folder/out/slabs.2/block.vtkhdf"
