#!/usr/bin/env bash
# What docs/cluster.md says of speed: one state in slabs, and files that are shared, on one process and
# on two, with the time of each and the processor time of each rank, children that read included, bytes
# exchanged and peak memory. Where others use the machine as well, processor times say more than the
# clock.
# Usage: scripts/measure_ranks.sh BUILD EDGE MEMORY [FOLDER]
# for a cube of EDGE^3 particles and as many again in eight files, a process having MEMORY (as 200MB).
# VERB=classify does that in the place of label; KINDS=slabs leaves the eight files out, and RANKS=2 one
# process.
set -euo pipefail
build=$1 edge=$2 memory=$3
folder=${4:-$(mktemp -d)}
kinds=${KINDS:-slabs files} verb=${VERB:-label}
mkdir -p "$folder"/{states,out}
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMP_NUM_THREADS=1

"$build/bin/make_block" "$edge" "$folder/block.vtkhdf"
if [[ $kinds == *files* ]]; then
    for i in 1 2 3 4 5 6 7 8; do
        "$build/bin/make_block" $((edge / 2)) "$folder/states/block_$i.vtkhdf"
    done
fi

# A rank, which says how long it worked.
# shellcheck disable=SC2016
timed='TIMEFORMAT="    rank $OMPI_COMM_WORLD_RANK: %U s and %S s of the system"; time "$@"'

# measure NAME RANKS INPUT OPTIONS...
measure() {
    local name=$1 ranks=$2 begin end
    shift 2
    rm -rf "$folder/out/$name.$ranks"
    begin=$(date +%s.%N)
    mpirun --bind-to none -n "$ranks" bash -c "$timed" _ "$build/bin/meniscus" "$verb" "$@" \
        -o "$folder/out/$name.$ranks" | tail -n 1
    end=$(date +%s.%N)
    echo "$name, $ranks process(es): $(awk "BEGIN { printf \"%.1f\", $end - $begin }") s"
}

for ranks in ${RANKS:-1 2}; do
    for kind in $kinds; do
        case $kind in
        slabs) measure slabs "$ranks" "$folder/block.vtkhdf" --memory "$memory" ;;
        files) measure files "$ranks" "$folder/states" ;;
        esac
    done
done
[ "${RANKS:-1 2}" != "1 2" ] || cmp "$folder/out/slabs.1/block.vtkhdf" "$folder/out/slabs.2/block.vtkhdf"
