#!/usr/bin/env python3
"""A study run by Slurm gives the database of a local run, also when tasks die.

usage: slurm_test.py BINARY [--people N] [--kills K]    as root; exit 0 good, 1 not, 2 no Slurm here

Drawn donnings. Brings up munged, slurmctld and slurmd of its own in a temporary folder, on free ports and for this machine alone,
and takes them down again. Of the study's array tasks K are killed (SIGKILL) while they run; they are to be submitted
again by the runner.
"""
import argparse
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

STUDY = """
[study]
name = "slurm"
modalities = ["imu-uncalibrated"]
seed = 11
[scenario.body]
posture = "a-pose"
[scenario.garment]
pattern = "tank-top"
[scenario.donning]
movements = []
[scenario.simulation]
edge_length = 0.05
[[axis]]
name = "person"
people = {{ statistics = "ansur-2012", count = {people} }}
[[axis]]
name = "fit"
key = "garment.fit.chest"
values = [0.02, 0.1]
[[axis]]
name = "put on"
donnings = 2
"""

CONFIGURATION = """
ClusterName=loosefit
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmdPort={node}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
ReturnToService=2
SchedulerParameters=sched_interval=1
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Cluster:
    """One machine as a cluster, for as long as the object is in use."""

    def __init__(self, folder):
        self.folder, self.running = folder, []
        self.environment = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf")}

    def __enter__(self):
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        host = socket.gethostname().split(".")[0]
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            host=host, folder=self.folder, controller=free_port(), node=free_port(), cpus=os.cpu_count()))
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        self.folder.chmod(0o755)
        try:
            self.start(["munged", "--foreground", "--force", f"--key-file={key}", f"--socket={self.folder}/munge.socket",
                        f"--log-file={self.folder}/munged.log", f"--pid-file={self.folder}/munged.pid",
                        f"--seed-file={self.folder}/munge.seed"])
            self.wait_for(lambda: (self.folder / "munge.socket").exists(), "munged")
            self.start(["slurmctld", "-D"])
            self.start(["slurmd", "-D"])
            self.wait_for(lambda: "idle" in self.ask("sinfo", "-h", "-o", "%T"), "a node that is idle")
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for process in reversed(self.running):
            process.terminate()
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()

    def start(self, command):
        program = shutil.which(command[0], path="/usr/sbin:/usr/bin:/sbin:/bin")
        with open(self.folder / f"{command[0]}.out", "wb") as out:
            self.running.append(subprocess.Popen([program, *command[1:]], stdout=out, stderr=out, env=self.environment))

    def ask(self, *command):
        return subprocess.run(command, capture_output=True, text=True, env=self.environment).stdout

    def wait_for(self, condition, what, seconds=60):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                logs = "\n".join(f"{log.name}: {log.read_text(errors='replace')[-1500:]}"
                                 for log in sorted(self.folder.glob("*.log")) + sorted(self.folder.glob("*.out")))
                raise SystemExit(f"error: {what} did not come up\n{logs}")
            time.sleep(0.2)


def tasks_at_work(folder):
    """Processes of array tasks of the study in this folder."""
    found = []
    for entry in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            words = (entry / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue
        if b"bundle" in words and str(folder).encode() in words:
            found.append(int(entry.name))
    return found


def run_local(binary, file, folder):
    end = subprocess.run([binary, "study", "run", file, "-o", folder, "--json"], capture_output=True, text=True)
    if end.returncode != 0:
        raise SystemExit(f"error: the local run ended with {end.returncode}: {end.stderr}")
    return json.loads(end.stdout)


def run_slurm(binary, file, folder, cluster, kills):
    runner = subprocess.Popen([binary, "study", "run", file, "-o", folder, "--json", "--executor", "slurm",
                               "--partition", "all", "--time", "10", "--bundle", "2"],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=cluster.environment)
    killed = 0
    while runner.poll() is None:
        if killed < kills:
            for process in tasks_at_work(folder)[:1]:
                time.sleep(0.3)
                try:
                    os.kill(process, signal.SIGKILL)
                    killed += 1
                except ProcessLookupError:
                    pass
        time.sleep(0.2)
    out, err = runner.communicate()
    if runner.returncode != 0:
        raise SystemExit(f"error: the run by Slurm ended with {runner.returncode}: {err}")
    return json.loads(out), killed


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("binary", type=pathlib.Path)
    parser.add_argument("--people", type=int, default=10, help="four cases each")
    parser.add_argument("--kills", type=int, default=5)
    arguments = parser.parse_args()
    missing = [name for name in ("munged", "slurmctld", "slurmd", "sbatch")
               if not shutil.which(name, path="/usr/sbin:/usr/bin:/sbin:/bin")]
    if missing or os.geteuid() != 0:
        print("error: " + ("not root" if not missing else "found no " + ", ".join(missing)) +
              "\nhint: as root: apt-get install --no-install-recommends slurm-wlm munge", file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory(prefix="loosefit-slurm-") as name:
        root = pathlib.Path(name)
        (root / "cluster").mkdir()
        file = root / "study.toml"
        file.write_text(STUDY.format(people=arguments.people))
        local = run_local(arguments.binary.resolve(), file, root / "local")
        with Cluster(root / "cluster") as cluster:
            begun = time.monotonic()
            remote, killed = run_slurm(arguments.binary.resolve(), file, root / "slurm", cluster, arguments.kills)
            took = time.monotonic() - begun
        print(f"{4 * arguments.people} cases, {killed} tasks killed, {took:.0f} s; rounds: "
              f"{len(list((root / 'slurm' / 'slurm').glob('bundles-*.txt')))}; "
              f"{local['done']} with scores, {local['sealed']} sealed, {local['failed']} failed")
        rounds = len(list((root / "slurm" / "slurm").glob("bundles-*.txt")))
        # Of failures and of a first round that never lost a task nothing could be told.
        for what, found, least in (("cases with scores", local["done"], 1), ("rounds", rounds, 2)):
            if found < least:
                print(f"error: {what}: found {found}, expected at least {least}", file=sys.stderr)
                return 1
        for key in ("content_sha256", "open", "done", "sealed", "failed"):
            if local[key] != remote[key]:
                print(f"error: {key}: found {remote[key]}, expected {local[key]} of the local run", file=sys.stderr)
                return 1
        if killed < arguments.kills:
            print(f"error: only {killed} tasks could be killed", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
