#!/usr/bin/env bash
# Runs scripts/label_campaign.slurm in a Slurm of one node, which lives in a folder of its own and ends with
# the test, and compares what it writes with what one process writes. Exit status 77 where Slurm is not
# installed (slurmctld, slurmd, slurm-client, munge) or this is not root, whom its daemons want.
# Usage: run_campaign.sh MENISCUS SOURCE
set -euo pipefail
meniscus=$1 source=$2
for program in munged slurmctld slurmd sbatch scontrol mpirun; do
    command -v "$program" >/dev/null || { echo "$program is missing"; exit 77; }
done
[ "$(id -u)" -eq 0 ] || { echo "not root"; exit 77; }

folder=$(mktemp -d)
daemons=()
finish() {
    for daemon in "${daemons[@]}"; do kill "$daemon" 2>/dev/null || true; done
    wait 2>/dev/null || true
    rm -rf "$folder"
}
trap finish EXIT
mkdir "$folder"/{munge,state,spool,states}
host=$(hostname -s)

# Who is who: a key for this test alone.
head -c 1024 /dev/urandom >"$folder/munge/key"
chmod 400 "$folder/munge/key"
chmod 755 "$folder"
chmod 711 "$folder/munge"
munged --foreground --force --key-file="$folder/munge/key" --socket="$folder/munge/socket" \
    --pid-file="$folder/munge/pid" --log-file="$folder/munge/log" --seed-file="$folder/munge/seed" &
daemons+=($!)

cat >"$folder/slurm.conf" <<END
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
SlurmctldPort=26817
SlurmdPort=26818
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
END
export SLURM_CONF=$folder/slurm.conf
slurmctld -D -f "$SLURM_CONF" >"$folder/slurmctld.log" 2>&1 &
daemons+=($!)
slurmd -D -f "$SLURM_CONF" -N "$host" >"$folder/slurmd.log" 2>&1 &
daemons+=($!)
for _ in $(seq 60); do
    sinfo --noheader --format=%t 2>/dev/null | grep -q idle && break
    sleep 0.5
done
sinfo --noheader --format=%t | grep -q idle || { cat "$folder"/*.log; exit 1; }

# As users do.
cp "$source"/data/samples/{droplet_iisph_01,droplet_iisph_04,cube_iisph_05}.vtkhdf "$folder/states"
export MENISCUS=$meniscus MENISCUS_MEMORY=500MB OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
sbatch --wait --quiet --nodes=1 --output="$folder/job.log" "$source/scripts/label_campaign.slurm" \
    "$folder/states" "$folder/labelled" "$folder/model.json" || { cat "$folder/job.log"; exit 1; }
cat "$folder/job.log"
"$meniscus" label "$folder/states" -o "$folder/alone" --quiet
"$meniscus" train "$folder/alone" -o "$folder/alone.json" --quiet
diff -r "$folder/alone" "$folder/labelled"
diff "$folder/alone.json" "$folder/model.json"
grep -q '"false_negatives": 0' "$folder/job.log"
