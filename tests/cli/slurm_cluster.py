"""A Slurm cluster of one node, this machine, for tests: munge, slurmctld and slurmd with a configuration of their own.

    sudo python3 slurm_cluster.py start | stop

Debian's slurm-wlm and munge must be installed. The configuration goes to /etc/slurm/slurm.conf, which must not be there or be one of
these; state and logs to a folder in /var/tmp.
"""
import os
import pathlib
import shutil
import socket
import subprocess
import sys
import time

CONF = pathlib.Path("/etc/slurm/slurm.conf")
STATE = pathlib.Path("/var/tmp/sundrape-slurm")
MARK = "# one node for the tests of sundrape"


def configuration():
    host = socket.gethostname().split(".")[0]
    return f"""{MARK}
ClusterName=sundrape
SlurmctldHost={host}(127.0.0.1)
AuthType=auth/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation={STATE}/ctld
SlurmdSpoolDir={STATE}/d
SlurmctldPidFile={STATE}/slurmctld.pid
SlurmdPidFile={STATE}/slurmd.pid
SlurmctldLogFile={STATE}/slurmctld.log
SlurmdLogFile={STATE}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
ReturnToService=2
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=1,batch_sched_delay=0,sched_min_interval=100000
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
KillWait=10
MinJobAge=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={os.cpu_count()} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def is_installed():
    return all(shutil.which(program) for program in ("slurmctld", "slurmd", "sbatch", "munged"))


def call(*command, check=True):
    return subprocess.run(command, check=check, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def start():
    """Returns when the node takes jobs."""
    if CONF.exists() and MARK not in CONF.read_text():
        raise SystemExit(f"{CONF} is there already: this machine belongs to a cluster")
    stop()
    for folder in (STATE / "ctld", STATE / "d"):
        folder.mkdir(parents=True)
    CONF.parent.mkdir(exist_ok=True)
    CONF.write_text(configuration())
    if subprocess.run(["munge", "-n"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode:
        os.makedirs("/run/munge", exist_ok=True)
        shutil.chown("/run/munge", "munge", "munge")
        call("runuser", "-u", "munge", "--", "munged", "--force")
    call("slurmctld", "-c")
    call("slurmd")
    until = time.monotonic() + 60
    while "idle" not in call("sinfo", "--noheader", "--format=%T", check=False).stdout:
        if time.monotonic() > until:
            raise SystemExit("the cluster does not come up:\n" + "".join(p.read_text() for p in STATE.glob("*.log")))
        time.sleep(0.2)


def stop():
    for program in ("slurmctld", "slurmd"):
        pid = STATE / f"{program}.pid"
        if pid.exists():
            call("kill", "-KILL", pid.read_text().strip(), check=False)
    shutil.rmtree(STATE, ignore_errors=True)
    if CONF.exists() and MARK in CONF.read_text():
        CONF.unlink()


if __name__ == "__main__":
    {"start": start, "stop": stop}[sys.argv[1]]()
