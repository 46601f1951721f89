"""One run of a case on one core, for the scripts of this folder."""

import json
import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def run_case(executable, folder, case, settings):
    """Runs cases/CASE into FOLDER/result.h5. Its summary, and in it `process_cpu`, the processor time of the whole
    process [s], and `ended`, false of a run that failed on its way.

    Raises RuntimeError if there was nothing to run."""
    summary = Path(folder) / "summary.json"
    command = [str(executable), "run", str(ROOT / "cases" / case), "-o", str(Path(folder) / "result.h5"), "--force",
               "--quiet", "--threads", "1", "--summary", str(summary)]
    for setting in settings:
        command += ["--set", setting]
    before = os.times()
    done = subprocess.run(command, check=False, capture_output=True, text=True,
                          env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
    after = os.times()
    if done.returncode not in (0, 1):
        raise RuntimeError(f"{' '.join(command)}\nended with status {done.returncode}: {done.stderr.strip()}")
    result = json.loads(summary.read_text())
    result["ended"] = done.returncode == 0
    result["process_cpu"] = (after.children_user + after.children_system
                             - before.children_user - before.children_system)
    return result
