"""The supervisor of all other programs that FreeCAD starts, so that it lives on whatever becomes of them.

A job is done by Python with child_main.py. Its folder holds what it needs and what it makes; job.json and the events, lines of
JSON on its output, are those of core/docs/ranks.md. Its input stays open as long as FreeCAD wants the result.
"""
import json
import os
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import paver_wb
from paver_wb import core
from paver_wb.formats import mesh_file
from paver_wb.processes import mesh_job

JOB, SHAPE, MESH, MAIN = "job.json", "shape.bin", "mesh.paver", "child_main.py"
INTERVAL, PATIENCE = 0.05, 0.5  # seconds between looks at the cancel token; until a process that was asked to end is killed
LOG_CHARACTERS = 2000


class ChildDied(RuntimeError):
    """The process ended without a result. The text is one sentence; `log`: the end of its error output."""

    place = None

    def __init__(self, text, log=""):
        super().__init__(text)
        self.log = log


class Stopped(Exception):
    """The cancel token was set."""


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


def command(folder):
    """Program and arguments that do the job in `folder`."""
    return [interpreter(), os.path.join(os.path.dirname(os.path.realpath(__file__)), MAIN), folder]


def environment():
    """Of this process, and where the packages lie, which FreeCAD's window takes out of PYTHONPATH. The last one is that
    of the compiled part, which may be another package of the name."""
    paver = core.load()
    packages = [os.path.dirname(os.path.dirname(os.path.realpath(module.__file__)))
                for module in (paver, paver_wb, paver._paver)]
    return {**os.environ, "PYTHONPATH": os.pathsep.join(packages)}


def content_of(job, folder, made):
    """What JOB says of a mesh_job.Job, whose shape is written; made: name of the file that comes of it."""
    with open(os.path.join(folder, SHAPE), "wb") as file:
        file.write(job.shape)
    return {"input": SHAPE, "name": job.name, "labels": job.labels, "options": job.options, "mesh": made, "sources": job.sources}


def write_content(content, folder):
    with open(os.path.join(folder, JOB), "w", encoding="utf-8") as file:
        json.dump(content, file)


def supervise(arguments, folder, take_line, cancel=None, variables=None, log=None, patience=PATIENCE):
    """Runs a program until it ends; its exit code. Stopped when `cancel` is set. Leaves no process behind.

    take_line: called with each line of its output. log: a file for its error output; without one that is a part of the
    output, the program has no input, and all the processes that it starts are ended with it.
    """
    is_group = log is None
    child = subprocess.Popen(arguments, stdin=subprocess.DEVNULL if is_group else subprocess.PIPE, stdout=subprocess.PIPE,
                             stderr=log or subprocess.STDOUT, cwd=folder, env=variables, start_new_session=is_group)
    try:
        rest, has_ended = b"", False
        while not has_ended:
            if cancel is not None and cancel.is_set():
                raise Stopped
            if select.select([child.stdout], [], [], INTERVAL)[0]:
                piece = os.read(child.stdout.fileno(), 65536)
                has_ended = not piece
                *whole, rest = (rest + piece).split(b"\n")
                for line in whole + [rest] * (has_ended and rest != b""):
                    take_line(line.decode(errors="replace"))
        return child.wait()
    finally:
        end(child, is_group, patience)


def end(child, is_group, patience):
    for which in (signal.SIGTERM, signal.SIGKILL):
        until = time.monotonic() + patience
        is_there = send(child, is_group, which)
        while is_there and time.monotonic() < until:
            time.sleep(0.01)
            is_there = send(child, is_group, 0)
    child.wait()
    child.stdout.close()
    if child.stdin:
        child.stdin.close()


def send(child, is_group, which):
    """Sends a signal; whether there is a process to take it. A group lives as long as its last process."""
    has_ended = child.poll() is not None
    if not is_group:
        if not has_ended:
            child.send_signal(which)
        return not has_ended
    try:
        os.killpg(child.pid, which)
    except ProcessLookupError:
        return False
    return True


def event_of(line):
    """The event that a line tells, {} where it tells none."""
    try:
        event = json.loads(line)
    except ValueError:
        return {}
    return event if isinstance(event, dict) else {}


def do(folder, error_of, death, progress=None, cancel=None, variables=None):
    """Does the job in a folder. Cancelled when it is stopped, error_of(event) when it tells of an error, ChildDied with the
    sentence death(exit code, last event) when it ends without a result."""
    last = {}

    def take(line):
        event = event_of(line)
        last.update(event)
        if event.get("event") == "progress" and progress and progress(event["stage"], event["percent"] / 100) is False:
            raise Stopped
    with tempfile.TemporaryFile() as log:
        try:
            status = supervise(command(folder), folder, take, cancel, {**environment(), **(variables or {})}, log)
        except Stopped:
            raise core.load().Cancelled("Cancelled; nothing was changed.", "cancelled") from None
        if last.get("event") == "error":
            raise error_of(last)
        if last.get("event") != "done":
            raise ChildDied(death(status, last), tail(log))


def error_of(event):
    """The exception that the child told about."""
    from paver import _errors
    error = _errors.CLASSES.get(event["code"], _errors.InternalError)(
        event["sentence"], *(event[name] for name in ("code", "remedy", "stage", "face", "edge", "point")))
    error.place = mesh_job.Place(*event["place"]) if event["place"] else None
    return error


def death(status, last):
    """What happened to a meshing process, and what to do."""
    stage = f" at the stage '{last['stage']}'" if "stage" in last else ""
    if status == -signal.SIGKILL:
        what = f"was killed{stage}, as the system does when memory runs out"
        remedy = "free memory or choose a larger target length"
    elif status < 0:
        what = f"crashed{stage} ({signal.Signals(-status).name})"
        remedy = "try another target length or Part's Check geometry, and report it with the model"
    else:
        what, remedy = f"ended{stage} without a result (exit code {status})", "see the log, and report it with the model"
    return f"The meshing process {what}, FreeCAD and the mesh are as before; {remedy}."


def run(job, folder, progress=None, cancel=None):
    """Does a mesh_job.Job in a process that uses `folder`, an empty one; (the StoredMesh, the path of its file there).

    progress(stage, fraction) and cancel as in paver.mesh; stopping takes at most half a second. ChildDied when the
    process ends without a result; else errors as those of mesh_job.run.
    """
    write_content(content_of(job, folder, MESH), folder)
    do(folder, error_of, death, progress, cancel)
    path = os.path.join(folder, MESH)
    return mesh_file.read(path), path


def tail(log):
    log.seek(max(0, log.seek(0, os.SEEK_END) - LOG_CHARACTERS))
    return log.read().decode(errors="replace").strip()
