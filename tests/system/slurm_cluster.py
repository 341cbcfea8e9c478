"""A Slurm cluster of nodes of one core each on this machine, in a temporary folder, as root.

Its programs die with the process that called in_own_processes, however that ends: they are in a
space of process numbers of its own, whose first process it is.
"""
import contextlib
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "scontrol", "sinfo", "squeue", "scancel")
INSIDE = "KEIKO_OWN_PROCESSES"
CONFIGURATION = """ClusterName=keiko
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={port}
SlurmUser=root
AuthType=auth/munge
# Without cred_expire a task that is started anew waits for two minutes.
AuthInfo=socket={folder}/munge.socket,cred_expire=5
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
MailProg=/bin/true
ReturnToService=2
SlurmdTimeout=4
BatchStartTimeout=2
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=1,sched_min_interval=0,bf_interval=1
"""
NODE = "NodeName={name} NodeHostname={host} NodeAddr=127.0.0.1 Port={port} CPUs=1\n"
PARTITION = "PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP\n"


def reason_against() -> str:
    """Why no cluster can be started here; empty if one can."""
    os.environ["PATH"] += ":/usr/sbin"
    missing = [program for program in PROGRAMS if not shutil.which(program)]
    if missing:
        return f"no {', '.join(missing)}; needs the packages slurm-wlm and munge"
    if os.geteuid() != 0:
        return "not root"
    own = subprocess.run(["unshare", "--pid", "--fork", "--mount-proc", "true"], capture_output=True, check=False)
    return "" if own.returncode == 0 else "no process namespaces"


def in_own_processes():
    """Starts this program anew such that all that it leaves behind is killed when it ends."""
    if INSIDE not in os.environ:
        os.environ[INSIDE] = "1"
        os.execvp("unshare", ["unshare", "--pid", "--fork", "--mount-proc", "--kill-child=SIGKILL",
                              sys.executable, "-B", *sys.argv])


def free_ports(count: int) -> list:
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [server.getsockname()[1] for server in sockets]
    for server in sockets:
        server.close()
    return ports


def processes() -> list:
    """Every process with its folder in /proc."""
    return [(int(entry.name), entry) for entry in Path("/proc").glob("[0-9]*")]


def read_bytes(path: Path) -> bytes:
    """Content of a file of a process; nothing where that has ended."""
    try:
        return path.read_bytes()
    except OSError:
        return b""


def parent_of(process: int) -> int:
    """Its number; 0 of a process that has ended."""
    return int((read_bytes(Path(f"/proc/{process}/stat")).rpartition(b")")[2].split() or [0, 0])[1])


def kill_all(running: set):
    for process in running:
        with contextlib.suppress(ProcessLookupError):  # has ended
            os.kill(process, signal.SIGKILL)


class Cluster:
    """Started when it is made; its commands are run with `run`."""

    def __init__(self, nodes: int):
        self.folder = Path(tempfile.mkdtemp(prefix="keiko-slurm-"))
        self.nodes = [f"n{number}" for number in range(1, nodes + 1)]
        self.environment = {**os.environ, "SLURM_CONF": str(self.folder / "slurm.conf")}
        self.daemons = {}
        self.log = open(self.folder / "daemons.log", "wb")
        try:
            self._configure()
            self._start()
        except BaseException:
            self.close()
            raise

    def _configure(self):
        host, ports = socket.gethostname(), free_ports(len(self.nodes) + 1)
        text = CONFIGURATION.format(host=host, port=ports[0], folder=self.folder)
        for name, port in zip(self.nodes, ports[1:]):
            text += NODE.format(name=name, host=host, port=port)
            (self.folder / f"spool-{name}").mkdir()
        (self.folder / "state").mkdir()
        (self.folder / "slurm.conf").write_text(text + PARTITION)
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)

    def _start(self):
        self._daemon("munged", "--foreground", "--force", *(f"--{kind}-file={self.folder}/munge.{end}" for kind, end in
                     (("key", "key"), ("pid", "pid"), ("log", "log"), ("seed", "seed"))),
                     f"--socket={self.folder}/munge.socket")
        self.wait_for(lambda: (self.folder / "munge.socket").exists(), "munged")
        self._daemon("slurmctld", "-D")
        for name in self.nodes:
            self.start_node(name)
        self.wait_for_nodes()

    def _daemon(self, *command: str, name: str = ""):
        self.daemons[name or command[0]] = subprocess.Popen(
            command, env=self.environment, stdin=subprocess.DEVNULL, stdout=self.log, stderr=self.log)

    def start_node(self, name: str):
        self._daemon("slurmd", "-D", "-N", name, name=name)

    def wait_for_nodes(self):
        """Until every node is idle."""
        self.wait_for(lambda: self.run("sinfo", "-h", "-o", "%T %D", check=False).strip() == f"idle {len(self.nodes)}",
                      "nodes")

    def kill_node(self, name: str):
        """Kills the programs of a node with the steps and tasks that it runs, as a loss of power would."""
        self.daemons[name].kill()
        self.daemons[name].wait()
        kill_all({*self.steps_on(name), *self.tasks_on(name)})

    def kill_step(self, name: str):
        """Kills the slurmstepd of a node, which leaves its tasks behind."""
        kill_all(self.steps_on(name))

    def steps_on(self, name: str) -> set:
        """The processes that watch the tasks of a node."""
        return {parent for parent in map(parent_of, self.tasks_on(name))
                if read_bytes(Path(f"/proc/{parent}/cmdline")).startswith(b"slurmstepd")}

    def tasks_on(self, name: str) -> list:
        """Processes of the tasks that a node runs."""
        return [process for process, entry in processes()
                if f"SLURMD_NODENAME={name}".encode() in read_bytes(entry / "environ").split(b"\0")]

    def run(self, *command: str, check: bool = True, **options) -> str:
        done = subprocess.run(command, env=self.environment, capture_output=True, text=True, timeout=60, check=False,
                              **options)
        if check and done.returncode:
            raise AssertionError(f"{' '.join(command)}: {done.stderr}")
        return done.stdout

    def wait_for(self, condition, what: str, seconds: float = 60):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                raise AssertionError(f"waited {seconds} s for {what}\n{self.report()}")
            time.sleep(0.1)

    def report(self) -> str:
        logs = [(self.folder / "slurmctld.log"), *self.folder.glob("slurmd-*.log")]
        return "\n".join(log.name + "\n" + log.read_text()[-1500:] for log in logs if log.exists())

    def close(self):
        """Ends the programs and removes the folder."""
        for daemon in reversed(self.daemons.values()):
            daemon.kill()
            daemon.wait()
        self.log.close()
        shutil.rmtree(self.folder, ignore_errors=True)
