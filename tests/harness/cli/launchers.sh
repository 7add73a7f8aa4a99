#!/usr/bin/env bash
# The launchers of docs/scale.md on this machine: GNU parallel and Slurm.  Each does in shards what one process does, and
# `cylon merge` must give the same report, times apart; a second start must find nothing left to do.
#   tests/harness/cli/launchers.sh parallel|slurm CYLON
# Exits 77, which ctest takes for skipped, where the launcher is not here.
set -euo pipefail
launcher=$1 cylon=$(realpath "$2") root=$(realpath "$(dirname "$0")/../../..")
scratch=$(mktemp -d)
daemons=()
stop() {
  for file in "${daemons[@]}"; do [ ! -s "$file" ] || kill "$(cat "$file")" 2>/dev/null || true; done
  rm -rf "$scratch" 2>/dev/null || { sleep 1; rm -rf "$scratch"; } # the daemons were still writing
}
trap stop EXIT
fail() { echo "FAILED: $*" >&2; exit 1; }
need() { for program; do command -v "$program" >/dev/null || { echo "skipped: there is no $program here" >&2; exit 77; }; done; }
export PATH="$(dirname "$cylon"):$PATH:/usr/sbin" CYLON_KEY=$scratch/key
unset GTEST_SHARD_INDEX GTEST_TOTAL_SHARDS TEST_SHARD_INDEX TEST_TOTAL_SHARDS ${!SLURM_ARRAY_TASK_*}
cd "$scratch"

cells=(heavy_top:projectile:bouncing_sphere:spring_chain --engine in-house --engine ode)
without_times() { grep -v '^"provenance"' "$1" | sed 's/"cpu_seconds": *[^,]*, *"cpu_verified": *[^,]*,//'; }
same_as_one() { # after the shards have run
  cylon merge .cylon/journal-*-of-3.jsonl --json all.json >/dev/null 2>merge.err || [ $? -eq 1 ] || fail "$(cat merge.err)"
  cmp <(without_times one/one.json) <(without_times all.json) || fail "another report than that of one process"
}
mkdir one
(cd one && { cylon run "${cells[@]}" --json one.json >/dev/null 2>&1 || [ $? -eq 1 ]; })

case $launcher in
  parallel)
    need parallel
    export PARALLEL_HOME=$scratch/parallel
    mkdir -p "$PARALLEL_HOME" && touch "$PARALLEL_HOME/will-cite"
    # The line itself, with few cells and three shards.
    line=$(grep '^parallel --joblog' "$root/docs/scale.md") || fail "docs/scale.md has no line of GNU parallel"
    line=${line//"\"'*'\""/"${cells[*]}"}
    line=${line//64/3}
    line=${line//-j 8/-j 2}
    grep -q -- "--shard {}/3" <<<"$line" || fail "the line is not as this test expects: $line"
    eval "$line" >/dev/null 2>parallel.err || true # its code is the number of shards with other verdicts than expected
    same_as_one
    [ "$(tail -n +2 shards.log | wc -l)" = 3 ] || fail "not three shards in the log: $(cat shards.log)"
    # A shard that was cut short does the rest alone.
    cp -r .cylon whole
    head -n 3 whole/journal-2-of-3.jsonl >.cylon/journal-2-of-3.jsonl
    sed -i '/--shard 2\/3/d' shards.log
    eval "$line" >/dev/null 2>parallel.err || true
    same_as_one
    grep -c '"cell"' .cylon/journal-?-of-3.jsonl >counts
    grep -c '"cell"' whole/journal-?-of-3.jsonl | sed s/whole/.cylon/ | diff - counts || fail "cells were lost or done twice"
    ;;
  slurm)
    need munged slurmctld slurmd sbatch
    host=$(hostname -s) me=$(id -un)
    dd if=/dev/urandom of=munge.key bs=1k count=1 status=none && chmod 600 munge.key && chmod 755 .
    ports=$(python3 -c 'import socket
s = [socket.socket() for _ in "ab"]
for one in s: one.bind(("127.0.0.1", 0))
print(*(one.getsockname()[1] for one in s))')
    read -r control daemon <<<"$ports"
    cat >slurm.conf <<END
ClusterName=loopback
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$me
SlurmdUser=$me
AuthInfo=socket=$scratch/munge.sock
StateSaveLocation=$scratch/state
SlurmdSpoolDir=$scratch/spool
SlurmctldPidFile=$scratch/slurmctld.pid
SlurmdPidFile=$scratch/slurmd.pid
SlurmctldLogFile=$scratch/slurmctld.log
SlurmdLogFile=$scratch/slurmd.log
SlurmctldPort=$control
SlurmdPort=$daemon
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/builtin
MpiDefault=none
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP OverSubscribe=FORCE:3
END
    mkdir state spool
    export SLURM_CONF=$scratch/slurm.conf
    daemons=("$scratch/slurmd.pid" "$scratch/slurmctld.pid" "$scratch/munge.pid")
    munged --force --socket="$scratch/munge.sock" --key-file="$scratch/munge.key" --log-file="$scratch/munge.log" \
      --pid-file="$scratch/munge.pid" --seed-file="$scratch/munge.seed" 2>munge.err
    slurmctld && slurmd
    for _ in $(seq 100); do sinfo -h -t idle 2>/dev/null | grep -q idle && break; sleep 0.1; done
    sinfo -h -t idle | grep -q idle || { echo "skipped: Slurm's daemons do not come up here: $(tail -n 3 slurmctld.log slurmd.log)" >&2; exit 77; }
    # The template as it stands, but for --exclusive, so that elements share this node.
    sed '/^#SBATCH --exclusive/d' "$root/docs/examples/cylon.sbatch" >template.sbatch
    submit() { sbatch --parsable --wait --array=5-9:2 --output="$scratch/element-%a.log" template.sbatch "${cells[@]}"; }
    submit >/dev/null || fail "the array failed: $(cat element-*.log)"
    same_as_one
    lines=$(cat .cylon/journal-*-of-3.jsonl | grep -c '"cell"')
    submit >/dev/null || fail "the second array failed: $(cat element-*.log)"
    [ "$(cat .cylon/journal-*-of-3.jsonl | grep -c '"cell"')" = "$lines" ] || fail "a requeued element did cells again"
    same_as_one
    ;;
  *) fail "no launcher $launcher" ;;
esac
echo "$launcher: the same report as one process"
