"""Hands a batch's tasks to Dask: FOLDER SCHEDULER JOBS, numbers of scripts on standard input, a line each.

Every task is a script NUMBER.sh in FOLDER that leaves its exit status in NUMBER.status; -1 is written there for one whose worker
was lost. FOLDER/stop, or the end of standard input, asks all tasks to write their checkpoints and stop. FOLDER/ended
says that this program is gone.
"""
import os
import signal
import subprocess
import sys
import threading

import dask
from distributed import Client, LocalCluster


def perform(folder, number):
    """On a worker: runs one script; passes a wish to stop on to it."""
    def die_with_the_worker():
        import ctypes
        ctypes.CDLL(None).prctl(1, signal.SIGTERM)  # PR_SET_PDEATHSIG

    stop = os.path.join(folder, "stop")
    if os.path.exists(stop):
        return
    script = os.path.join(folder, f"{number}.sh")
    child = subprocess.Popen(["/bin/sh", script], start_new_session=True, preexec_fn=die_with_the_worker)
    told = False
    while True:
        try:
            child.wait(0.2)
            return
        except subprocess.TimeoutExpired:
            if not told and os.path.exists(stop):
                os.killpg(child.pid, signal.SIGINT)
                told = True


def write(folder, name, text):
    path = os.path.join(folder, name)
    with open(path + ".tmp", "w") as file:
        file.write(text)
    os.replace(path + ".tmp", path)


def main():
    folder, scheduler, jobs = sys.argv[1], sys.argv[2], int(sys.argv[3])
    dask.config.set({"distributed.scheduler.allowed-failures": 0, "distributed.admin.tick.limit": "1h"})
    if scheduler:
        client = Client(scheduler)
    else:
        workers = jobs or len(os.sched_getaffinity(0))
        client = Client(LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None, memory_limit=0))
    idle, working = threading.Condition(), set()

    def ended(number):
        def note(future):
            if future.status != "finished":
                write(folder, f"{number}.status", "-1")
            elif not os.path.exists(os.path.join(folder, f"{number}.status")):
                write(folder, f"{number}.status", "130" if os.path.exists(os.path.join(folder, "stop")) else "-1")
            with idle:
                working.discard(number)
                futures.pop(number, None)
                idle.notify_all()

        return note

    futures = {}
    for line in sys.stdin:
        number = int(line)
        with idle:
            working.add(number)
        future = client.submit(perform, folder, number, key=f"{folder}:{number}", pure=False)
        futures[number] = future
        future.add_done_callback(ended(number))
    # who reads our results is gone, or done with all of them
    if working:
        write(folder, "stop", "")
        with idle:
            idle.wait_for(lambda: not working, 60)
    client.close()


if __name__ == "__main__":  # workers import this file too
    try:
        main()
    finally:
        if os.path.isdir(sys.argv[1]):
            write(sys.argv[1], "ended", "")
