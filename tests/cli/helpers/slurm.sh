# SPDX-License-Identifier: AGPL-3.0-or-later
# For test scripts (sourced, after tests/tap.sh): a Slurm of one node, this machine, whose services
# listen on loopback alone, with key, settings, state and logs in $scratch/slurm.
#
#   start_slurm [NODE-OPTIONS]   starts munged, slurmctld and slurmd and waits until the node is idle;
#                                sets SLURM_CONF. Fails with a reason in $slurm_reason where these
#                                programs are missing or do not start
#   stop_slurm                   ends them, and what they run; is called at the script's end too

slurm=$scratch/slurm
slurm_reason=
slurm_services=()
PATH=$PATH:/usr/sbin:/sbin

# a free port of loopback, from a number on
free_port() {
    local port=$1
    while (exec 3<> "/dev/tcp/127.0.0.1/$port") 2> /dev/null; do port=$((port + 1)); done
    echo $port
}

# until SECONDS COMMAND...: waits for it to succeed
until_it() {
    local end=$((SECONDS + $1))
    shift
    until "$@" > /dev/null 2>&1; do
        [ $SECONDS -lt $end ] || return 1
        sleep 0.2
    done
}

start_slurm() {
    local program user port host address cores memory
    for program in munged slurmctld slurmd sbatch squeue scancel scontrol; do
        command -v $program > /dev/null || { \
            slurm_reason="there is no $program (packages slurm-wlm and munge)"; return 1; }
    done
    user=$(id -un) host=$(hostname -s)
    # Services listen at this machine's own name's address; installers give the name 127.0.1.1.
    address=$(getent ahostsv4 "$host" | awk '/^127[.]/ { print $1; exit }') || true
    address=${address:-127.0.0.1}
    port=$(free_port $((20000 + $$ % 20000)))
    cores=$(nproc) memory=$(awk '/^MemTotal/ { print int($2 / 1024) }' /proc/meminfo)
    mkdir -p -m 755 "$slurm"/{state,spool,log} "$slurm/munge"
    chmod 700 "$slurm/munge"
    chmod a+x "$scratch" # munged's socket has to be reachable
    dd if=/dev/urandom of="$slurm/munge/key" bs=128 count=1 2> /dev/null
    chmod 600 "$slurm/munge/key"
    cat > "$slurm/slurm.conf" <<-end
	ClusterName=test
	SlurmctldHost=$host($address)
	SlurmctldPort=$port
	SlurmdPort=$((port + 1))
	SlurmUser=$user
	SlurmdUser=$user
	AuthType=auth/munge
	AuthInfo=socket=$slurm/munge/socket
	CredType=cred/munge
	StateSaveLocation=$slurm/state
	SlurmdSpoolDir=$slurm/spool
	SlurmctldPidFile=$slurm/slurmctld.pid
	SlurmdPidFile=$slurm/slurmd.pid
	SlurmctldLogFile=$slurm/log/slurmctld
	SlurmdLogFile=$slurm/log/slurmd
	ProctrackType=proctrack/linuxproc
	TaskPlugin=task/none
	SwitchType=switch/none
	MpiDefault=none
	SelectType=select/cons_tres
	SelectTypeParameters=CR_Core
	SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0,bf_interval=1
	JobAcctGatherType=jobacct_gather/none
	AccountingStorageType=accounting_storage/none
	ReturnToService=2
	KillWait=1
	MinJobAge=300
	CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
	MessageTimeout=60
	MaxArraySize=${slurm_array_size:-1001}
	NodeName=$host NodeAddr=$address CPUs=$cores RealMemory=$memory State=UNKNOWN ${1:-}
	PartitionName=main Nodes=$host Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO
	end
    # From 23.11 on slurmd does not start without a cgroup file system, which containers may lack,
    # unless its plugin is disabled; 22.05 lacks the setting.
    [ "$(printf '%s\n' 23.11 "$(slurmd -V | grep -o '[0-9][0-9.]*' | head -1)" | sort -V | head -1)" != 23.11 ] ||
        echo 'CgroupPlugin=disabled' > "$slurm/cgroup.conf"
    export SLURM_CONF=$slurm/slurm.conf
    trap 'stop_slurm; rm -rf "$scratch"' EXIT
    munged --foreground --force --key-file="$slurm/munge/key" --socket="$slurm/munge/socket" --pid-file="$slurm/munge/pid" \
        --log-file="$slurm/munge/log" --seed-file="$slurm/munge/seed" > "$slurm/log/munged" 2>&1 & slurm_services+=($!)
    until_it 10 test -S "$slurm/munge/socket" ||
        { slurm_reason="munged does not start: $(tail -1 "$slurm/log/munged")"; return 1; }
    slurmctld -D -f "$SLURM_CONF" > "$slurm/log/slurmctld.said" 2>&1 & slurm_services+=($!)
    slurmd -D -f "$SLURM_CONF" -N "$host" > "$slurm/log/slurmd.said" 2>&1 & slurm_services+=($!)
    until_it 60 node_is_idle || { \
        slurm_reason="its node does not become idle: $(cat "$slurm"/log/slurm*.said | grep -i error | tail -1)"; \
        return 1; }
}

node_is_idle() { [ "$(sinfo -h -o %T)" = idle ]; }
queue_is_empty() { [ -z "$(timeout 5 squeue -h)" ]; }
has_ended() { ! kill -0 "$1" 2> /dev/null || [ "$(sed 's/.*) //; s/ .*//' "/proc/$1/stat" 2> /dev/null)" = Z ]; }

# Ends the tasks first, so that services are still there to receive their ends. A service that does
# not end is killed.
stop_slurm() {
    local service
    [ ${#slurm_services[@]} = 0 ] || {
        timeout 10 scancel --user="$(id -un)" 2> /dev/null || true
        until_it 15 queue_is_empty || true
    }
    for ((service = ${#slurm_services[@]} - 1; service >= 0; service--)); do
        kill "${slurm_services[service]}" 2> /dev/null || true
        until_it 5 has_ended "${slurm_services[service]}" || kill -9 "${slurm_services[service]}" 2> /dev/null || true
        wait "${slurm_services[service]}" 2> /dev/null || true
    done
    slurm_services=()
}
