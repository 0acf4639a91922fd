# shellcheck shell=bash
# A Slurm of its own in a folder, on this machine: sourced. Its nodes are daemons under names of their own. Needs
# slurmctld, slurmd, slurm-client and munge; whoever runs it is the one user that it has.
#   cluster_start FOLDER NODES    writes the configuration, starts all, and waits until the nodes are idle
#   node_start N, node_kill N     a node's daemon; killed as by the loss of power: with all that it runs, at once
#   cluster_stop                  ends every process of it, at once
# A node has a host's name of its own: this host's, and its number.
# cluster_scheduler and cluster_timeout are Slurm's SchedulerParameters (default: its own) and SlurmdTimeout (5 s).
# Sets SLURM_CONF. Ports are free ones, so that several may run beside each other.

cluster='' cluster_nodes=0
free_port() { # sets `port` to one that nothing listens on, another each time
    while :; do
        port=$((20000 + RANDOM % 20000))
        [[ " $cluster_ports " == *" $port "* ]] && continue
        (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null || break
    done
    cluster_ports+=" $port"
}

cluster_start() {
    cluster=$1 cluster_nodes=$2
    mkdir -p "$cluster"/{state,munge,log}
    chmod 700 "$cluster/munge"
    dd if=/dev/urandom of="$cluster/munge/key" bs=1024 count=1 status=none
    chmod 600 "$cluster/munge/key"
    munged --force --key-file="$cluster/munge/key" --socket="$cluster/munge/socket" --pid-file="$cluster/munge/pid" \
        --log-file="$cluster/log/munged" --seed-file="$cluster/munge/seed" 2>"$cluster/log/munged.said"
    export SLURM_CONF=$cluster/slurm.conf
    local n cpus port cluster_ports=''
    cpus=$(nproc)
    {
        free_port
        echo "ClusterName=farm
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthType=auth/munge
AuthInfo=socket=$cluster/munge/socket
SlurmctldPort=$port
StateSaveLocation=$cluster/state
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmctldLogFile=$cluster/log/slurmctld
SlurmdPidFile=$cluster/slurmd.%n.pid
SlurmdSpoolDir=$cluster/spool.%n
SlurmdLogFile=$cluster/log/slurmd.%n
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/linear
${cluster_scheduler:+SchedulerParameters=$cluster_scheduler}
SlurmdTimeout=${cluster_timeout:-5}
SlurmctldTimeout=5
KillWait=2
ReturnToService=2
MpiDefault=none
SwitchType=switch/none
MaxArraySize=${cluster_array:-1001}"
        for ((n = 0; n < cluster_nodes; ++n)); do
            free_port
            echo "NodeName=n$n NodeAddr=127.0.0.1 NodeHostname=$(hostname) Port=$port CPUs=$cpus State=UNKNOWN"
        done
        echo "PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP"
    } >"$SLURM_CONF"
    # Newer daemons end where control groups are not theirs to make, as in containers; older ones do not know the word.
    [[ $(slurmctld -V) =~ \ (1|20|21|22|23)[0-9]*\. ]] || echo "CgroupPlugin=disabled" >"$cluster/cgroup.conf"
    slurmctld -f "$SLURM_CONF" -L "$cluster/log/slurmctld" >"$cluster/log/slurmctld.said" 2>&1
    for ((n = 0; n < cluster_nodes; ++n)); do node_start $n || true; done  # told below
    for ((n = 0; n < 300 + 2 * cluster_nodes; ++n)); do
        [ "$(sinfo -h -N -o '%T' 2>/dev/null | grep -c '^idle$')" = "$cluster_nodes" ] && return 0
        sleep 0.2
    done
    echo "the nodes do not come up:" >&2
    sinfo -N >&2 || true
    tail -n 20 "$cluster"/log/* >&2
    return 1
}

node_start() {
    mkdir -p "$cluster/spool.n$1"
    # A host's name of its own: what programs say of their machine is the node's.
    unshare --uts bash -c 'hostname "$1" && exec slurmd -f "$2" -N "$3"' - "$(hostname)-n$1" \
        "$SLURM_CONF" "n$1" >>"$cluster/log/slurmd.n$1.said" 2>&1
}

below() { # below PID...: these processes and all that they started, whatever group or session that is in
    local pid
    for pid; do
        echo "$pid"
        # shellcheck disable=SC2046
        below $(cat "/proc/$pid/task/$pid/children" 2>/dev/null)
    done
}

node_steps() { # node_steps N: what manages the node's tasks; it is no child of the daemon
    local pid
    for pid in $(pgrep -x slurmstepd); do
        # By its log, the node's alone: two clusters may have a node of one name.
        [ -z "$(find "/proc/$pid/fd" -lname "$cluster/log/slurmd.n$1" 2>/dev/null)" ] || echo "$pid"
    done
}

node_kill() {
    local pids
    # shellcheck disable=SC2046
    pids=$(below $(cat "$cluster/slurmd.n$1.pid" 2>/dev/null) $(node_steps "$1"))
    # shellcheck disable=SC2086
    kill -9 $pids 2>/dev/null || true
}

cluster_stop() {
    local n
    [ -n "$cluster" ] || return 0
    for ((n = 0; n < cluster_nodes; ++n)); do node_kill $n; done
    # shellcheck disable=SC2046
    kill -9 $(below $(cat "$cluster/slurmctld.pid" 2>/dev/null)) 2>/dev/null || true
    kill "$(cat "$cluster/munge/pid" 2>/dev/null)" 2>/dev/null || true
}
