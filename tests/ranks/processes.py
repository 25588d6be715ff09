"""Starts runs of several ranks and looks at their processes, for the tests beside it."""
import json
import os
import signal
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import runs  # noqa: E402
from process import is_alive, process  # noqa: E402

PROGRAM = runs.PROGRAM
WORKER = os.path.join(os.path.dirname(PROGRAM), "paver-worker")
WING = os.path.join(runs.EXAMPLES, "wing.step")
PROMISE = 2.0  # seconds in which all processes of a stopped run end
PATIENCE = 3 * PROMISE  # how long tests wait for that, on a machine that does other things, too


def wait_until(is_true, seconds=60):
    """What `is_true` gives, asked again and again until it is not nothing; after `seconds` whatever it is."""
    end = time.monotonic() + seconds
    while True:
        found = is_true()
        if found or time.monotonic() > end:
            return found
        time.sleep(0.02)


def descendants(pid):
    """{pid: command line} of what a process has started, and they in turn."""
    everything = {int(name): process(name) for name in os.listdir("/proc") if name.isdigit()}
    found = {}
    for candidate in everything:
        above = candidate
        while above in everything and everything[above] and above != pid:
            above = everything[above][0]
        if above == pid and candidate != pid:
            try:
                with open(f"/proc/{candidate}/cmdline") as f:
                    found[candidate] = f.read().split("\0")[:-1]
            except OSError:
                pass
    return found


class Run:
    """One `paver mesh ... --ranks N` in folders of its own: `out` for its files, `tmp` as TMPDIR."""

    def __init__(self, folder, ranks, *options, model=WING, program=None, **environment):
        self.folder, self.ranks = str(folder), ranks
        self.out, self.tmp = os.path.join(self.folder, "out"), os.path.join(self.folder, "tmp")
        os.makedirs(self.out, exist_ok=True)
        os.makedirs(self.tmp, exist_ok=True)
        self.shared_memory = set(os.listdir("/dev/shm"))
        self.mesh = os.path.join(self.out, "wing.msh")
        command = [*(program or [PROGRAM]), "mesh", model, "-o", self.mesh, "--ranks", str(ranks), *map(str, options)]
        self.log = open(os.path.join(self.folder, "stdout"), "w+")
        self.errors = open(os.path.join(self.folder, "stderr"), "w+")
        self.child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=self.log, stderr=self.errors,
                                      env={**os.environ, "TMPDIR": self.tmp, **environment}, start_new_session=True)
        self.known = set()

    def said(self, name="stdout"):
        with open(os.path.join(self.folder, name)) as f:
            return f.read()

    def processes(self):
        """All that run now; they are remembered."""
        found = descendants(self.child.pid)
        self.known |= set(found)
        return found

    def workers(self):
        """Pids of the ranks."""
        return sorted(pid for pid, command in self.processes().items()
                      if command and os.path.basename(command[0]) == "paver-worker")

    def rank(self, number):
        """Pid of one rank."""
        for pid in self.workers():
            with open(f"/proc/{pid}/environ") as f:
                if f"OMPI_COMM_WORLD_RANK={number}" in f.read().split("\0"):
                    return pid
        raise AssertionError(f"no rank {number}")

    def watcher(self):
        return next(pid for pid, command in self.processes().items() if os.path.basename(command[0]) == "paver-watch")

    def mpirun(self):
        """From Open MPI 5 on it becomes another program."""
        return next(pid for pid, command in self.processes().items()
                    if os.path.basename(command[0]) in ("mpirun", "prterun"))

    def wait_for_paving(self):
        """Until all ranks run and have come to the longest stage."""
        ready = wait_until(lambda: self.child.poll() is not None or
                           "regions" in self.said() and len(self.workers()) == self.ranks)
        assert ready and self.child.poll() is None, self.said() + self.said("stderr")
        self.processes()

    def wait(self, seconds=60):
        """The exit code."""
        return self.child.wait(timeout=seconds)

    def expect_nothing_left(self, files=()):
        """No process, no temporary folder, no file but those given."""
        alive = lambda: [pid for pid in self.known if is_alive(pid)]  # noqa: E731
        assert wait_until(lambda: not alive(), PATIENCE), f"still there: {alive()}"
        assert wait_until(lambda: not os.listdir(self.tmp), PATIENCE), os.listdir(self.tmp)
        assert wait_until(lambda: not set(os.listdir("/dev/shm")) - self.shared_memory, PATIENCE)
        assert sorted(os.listdir(self.out)) == sorted(files)

    def sentence(self):
        """What it said on stderr: exactly one sentence."""
        text = self.said("stderr")
        lines = text.splitlines()
        assert len(lines) == 1 and lines[0].startswith("paver: ") and lines[0].endswith("."), text
        return lines[0]

    def close(self):
        """Ends what a failed test has left."""
        for pid in [self.child.pid, *self.known]:
            if is_alive(pid):
                os.kill(pid, signal.SIGKILL)
        self.child.wait()
        self.log.close()
        self.errors.close()


def by_hand(job, ranks=2, **more):
    """Runs a job file as one would on a cluster. Open MPI 5 puts zero bytes between lines."""
    done = subprocess.run(["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks), WORKER, str(job)],
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120, **more)
    done.stdout, done.stderr = (text.replace("\0", "") for text in (done.stdout, done.stderr))
    return done


def write_job(path, **keys):
    with open(path, "w") as f:
        json.dump(keys, f)
    return path
