"""Runs a job in a process of its own, so that FreeCAD lives on whatever becomes of it.

The process is Python with paver_wb/child_main.py; fem_process.py has one for FreeCAD's formats of files. A folder holds what it needs and what it makes; a line of JSON on its
output for each step of the progress, and one at the end; its input stays open as long as FreeCAD wants the result.
"""
import json
import os
import select
import shutil
import signal
import subprocess
import sys
import tempfile

from paver_wb import core, mesh_file, mesh_job

JOB, SHAPE, MESH, MAIN = "job.json", "shape.bin", "mesh.paver", "child_main.py"
INTERVAL, PATIENCE = 0.05, 0.5  # seconds between looks at the cancel token; until a process that was asked to end is killed
LOG_CHARACTERS = 2000


class ChildDied(RuntimeError):
    """The process ended without a result. The text is one sentence; `log`: the end of its error output."""

    place, log = None, ""


def interpreter():
    """The Python program of the version that runs this; in FreeCAD sys.executable is FreeCAD itself."""
    name = "python{}.{}".format(*sys.version_info[:2])
    found = [path for path in (sys.executable or "", os.path.join(sys.base_prefix, "bin", name),
                               os.path.join(sys.base_prefix, "python.exe"), shutil.which(name) or "")
             if os.path.basename(path).startswith("python") and os.path.isfile(path)]
    if not found:
        raise ChildDied(f"There is no program {name} to mesh in a process of its own; install it, or set the mesh's "
                        "property RunIn to FreeCAD.")
    return found[0]


def command(folder, main=MAIN):
    """Program and arguments that do the job in `folder`; main: the file of this package that does it."""
    return [interpreter(), os.path.join(os.path.dirname(os.path.realpath(__file__)), main), folder]


def environment():
    """Of this process, and where the packages lie, which FreeCAD's window takes out of PYTHONPATH. The last one is that
    of the compiled part, which may be another package of the name."""
    paver = core.load()
    packages = [os.path.dirname(os.path.dirname(os.path.realpath(module.__file__)))
                for module in (paver, sys.modules[__package__], paver._paver)]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(packages)}


def write_job(job, folder):
    with open(os.path.join(folder, SHAPE), "wb") as file:
        file.write(job.shape)
    with open(os.path.join(folder, JOB), "w", encoding="utf-8") as file:
        json.dump(job._replace(shape="")._asdict(), file)


class Lines:
    """Whole lines out of a pipe that gives pieces."""

    def __init__(self, pipe):
        self.pipe, self.rest, self.has_ended = pipe, b"", False

    def read(self, seconds):
        """Messages that have come after at most so many seconds; what is no message is left out."""
        if not select.select([self.pipe], [], [], seconds)[0]:
            return []
        piece = os.read(self.pipe.fileno(), 65536)
        self.has_ended = not piece
        *whole, self.rest = (self.rest + piece).split(b"\n")
        return [message for message in map(message_of, whole) if message]


def message_of(line):
    try:
        message = json.loads(line)
    except ValueError:
        return None
    return message if isinstance(message, dict) else None


def follow(child, progress, cancel):
    """Passes on the progress until the child ends or is to be stopped; its last message, Cancelled when stopped."""
    lines, last = Lines(child.stdout), {}
    while not lines.has_ended:
        for message in lines.read(INTERVAL):
            last = message
            if "stage" in message and progress and progress(message["stage"], message["fraction"]) is False:
                raise cancelled()
        if cancel is not None and cancel.is_set():
            raise cancelled()
    return last


def cancelled():
    return core.load().Cancelled("Cancelled; nothing was changed.", "cancelled")


def end(child):
    """Leaves no process behind."""
    if child.poll() is None:
        child.terminate()
    try:
        child.wait(PATIENCE)
    except subprocess.TimeoutExpired:
        child.kill()
        child.wait()
    child.stdin.close()
    child.stdout.close()


def error_of(message):
    """The exception that the child told about."""
    paver = core.load()
    fields = message["error"]
    error = getattr(paver, fields["class"], paver.InternalError)(
        fields["text"], fields["code"], fields["remedy"], fields["stage"], fields["face"], fields["edge"],
        fields["point"])
    error.place = mesh_job.Place(*fields["place"]) if fields["place"] else None
    return error


def death(status, last, log):
    """ChildDied with what happened and what to do."""
    stage = f" at the stage '{last['stage']}'" if "stage" in last else ""
    if status == -signal.SIGKILL:
        what = f"was killed{stage}, as the system does when memory runs out"
        remedy = "free memory or choose a larger target length"
    elif status < 0:
        what = f"crashed{stage} ({signal.Signals(-status).name})"
        remedy = "try another target length or Part's Check geometry, and report it with the model"
    else:
        what, remedy = f"ended{stage} without a result (exit code {status})", "see the log, and report it with the model"
    error = ChildDied(f"The meshing process {what}, FreeCAD and the mesh are as before; {remedy}.")
    error.log = log
    return error


def supervise(arguments, folder, progress=None, cancel=None, variables=None):
    """Runs a program until it ends or is stopped; (its exit code, its last message, the end of its error output).

    variables: further ones of its environment. Leaves no process behind.
    """
    with tempfile.TemporaryFile() as log:
        child = subprocess.Popen(arguments, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=log, cwd=folder,
                                 env={**environment(), **(variables or {})})
        try:
            last = follow(child, progress, cancel)
            status = child.wait()
        finally:
            end(child)
        return status, last, tail(log)


def run(job, folder, progress=None, cancel=None):
    """Does the job in a process that uses `folder`, an empty one; (the StoredMesh, the path of its file there).

    progress(stage, fraction) and cancel as in paver.mesh; stopping takes at most half a second. ChildDied when the
    process ends without a result; else errors as those of mesh_job.run.
    """
    write_job(job, folder)
    status, last, log = supervise(command(folder), folder, progress, cancel)
    if "error" in last:
        raise error_of(last)
    if "done" not in last:
        raise death(status, last, log)
    path = os.path.join(folder, MESH)
    return mesh_file.read(path), path


def tail(log):
    log.seek(max(0, log.seek(0, os.SEEK_END) - LOG_CHARACTERS))
    return log.read().decode(errors="replace").strip()
