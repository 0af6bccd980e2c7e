"""test_slurm.py - the README's array of a cluster: with munge, slurmctld and slurmd on this machine, whose files
and ports are the test's own.
"""
from __future__ import annotations

import os
import pwd
import shlex
import shutil
import socket
import subprocess
import tempfile
import time
import unittest
from contextlib import contextmanager
from pathlib import Path

from .fixtures import Sentences
from .small_class import SEED, build_class, command, grade, records

os.environ["PATH"] += ":/usr/sbin:/sbin"    # there the daemons are
DAEMONS = ("munged", "slurmctld", "slurmd")
HANGS = 600     # seconds: for what hangs, however busy the machine is
CONFIGURATION = """ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={work}/munge
CredType=cred/munge
StateSaveLocation={work}/state
SlurmdSpoolDir={work}/spool
SlurmctldPidFile={work}/slurmctld.pid
SlurmdPidFile={work}/slurmd.pid
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
KillWait=5
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
NodeName={host} NodeAddr=127.0.0.1 CPUs={processors} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def until(what: str, holds) -> None:
    began = time.monotonic()
    while not holds():
        if time.monotonic() - began > HANGS:
            raise TimeoutError(f"after {HANGS} s: not {what}")
        time.sleep(0.1)


def free_ports(count: int) -> list[int]:
    doors = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [door.getsockname()[1] for door in doors]
    for door in doors:
        door.close()
    return ports


@contextmanager
def cluster(work: Path):
    """A cluster of this machine; gives the environment of its commands."""
    for name in ("state", "spool"):
        (work / name).mkdir()
    (work / "key").write_bytes(os.urandom(128))
    (work / "key").chmod(0o600)
    (work / "slurm.conf").write_text(CONFIGURATION.format(
        host=socket.gethostname().split(".")[0], user=pwd.getpwuid(os.getuid()).pw_name, work=work,
        ports=free_ports(2), processors=len(os.sched_getaffinity(0))))
    environment = {**os.environ, "SLURM_CONF": str(work / "slurm.conf"), "SEED": SEED, "JOBS": "1"}
    started = []
    try:
        for name, *options in (["munged", "-F", "--force", f"--socket={work}/munge", f"--key-file={work}/key",
                                f"--pid-file={work}/munged.pid", f"--log-file={work}/munged.log",
                                f"--seed-file={work}/seed"], ["slurmctld", "-D"], ["slurmd", "-D"]):
            with open(work / f"{name}.said", "wb") as said:
                started.append(subprocess.Popen([name, *options], env=environment, stdin=subprocess.DEVNULL,
                                                stdout=said, stderr=said))
            if name == "munged":
                until("munged answers", (work / "munge").exists)
        until("a node is idle", lambda: b"idle" in subprocess.run(
            ["sinfo", "-h", "-o", "%t"], env=environment, capture_output=True, check=False).stdout
            or any(each.poll() is not None for each in started))
        yield environment
    finally:
        subprocess.run(["scancel", "--user", str(os.getuid())], env=environment, capture_output=True, check=False)
        for each in reversed(started):
            each.terminate()
            each.wait()


@unittest.skipUnless(all(map(shutil.which, (*DAEMONS, "sbatch"))),
                     "a cluster: munge and Slurm are missing (Debian: slurm-wlm)")
class Slurm(Sentences):
    def test_an_array_shares_the_work(self) -> None:
        with tempfile.TemporaryDirectory() as temporary:
            work = Path(temporary)
            folder, out = work / "class", work / "out"
            build_class(folder)
            alone = grade(folder, work / "alone")
            self.assertEqual(alone.returncode, 0, alone.stderr[-500:])
            with cluster(work) as environment:
                self.arrays(folder, out, work, environment)
            merged = grade(folder, out)
            self.check("once more, without a shard, marks nothing and writes the reports",
                       merged.returncode == 0 and merged.stderr.count("(kept)") == len(records(out)), merged.stderr[-500:])
            self.check("the marks are those of one machine", records(out) == records(work / "alone"))
            self.check("and grades.csv is the same, byte by byte",
                       (out / "grades.csv").read_bytes() == (work / "alone" / "grades.csv").read_bytes())

    def arrays(self, folder: Path, out: Path, work: Path, environment: dict) -> None:
        wrapped = f"SHARD=$SLURM_ARRAY_TASK_ID/3 {shlex.join(command(folder, out))}"

        def submit(*options: str) -> subprocess.CompletedProcess:
            return subprocess.run(["sbatch", "--parsable", "--array=1-3", "--cpus-per-task=1", f"--output={work}/%A_%a.said",
                                   *options, "--wrap", wrapped], env=environment, capture_output=True, text=True, check=False)
        first = submit()
        job = first.stdout.strip()
        self.check("an array is taken", first.returncode == 0 and job.isdecimal(), first.stderr)
        until("a first result", lambda: any(out.glob("*/results.json")))
        cancelled = subprocess.run(["scancel", job], env=environment, check=False)
        until("the array ended", lambda: not subprocess.run(
            ["squeue", "-h", "-j", job], env=environment, capture_output=True, check=False).stdout)
        self.check("scancel ends it", cancelled.returncode == 0)
        again = submit("--wait")
        said = "".join(path.read_text() for path in work.glob(f"{again.stdout.strip()}_*.said"))
        self.check("the same array again does the rest", again.returncode == 0, again.stderr + said[-500:])
