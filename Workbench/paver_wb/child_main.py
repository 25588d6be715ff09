"""The program of a process that does one job for FreeCAD: child_main.py FOLDER; see child_process.py."""
import json
import os
import shutil
import sys
import threading

from paver_wb import child_process, core, mesh_file, mesh_job


NICENESS = 5  # FreeCAD's window comes first


def take_output():
    """A file for messages only: whatever else writes to the output ends up in the log."""
    messages = os.fdopen(os.dup(1), "w", encoding="utf-8", buffering=1)
    os.dup2(2, 1)
    return messages


def end_with_parent(folder, has_finished):
    """Ends this process when FreeCAD closes its input, as it does also by dying, and leaves no files behind then."""
    def wait():
        while os.read(0, 4096):
            pass
        if not has_finished.is_set():
            shutil.rmtree(folder, ignore_errors=True)
            os._exit(1)
    threading.Thread(target=wait, daemon=True).start()


def read_job(folder):
    with open(os.path.join(folder, child_process.JOB), encoding="utf-8") as file:
        job = mesh_job.Job(**json.load(file))
    with open(os.path.join(folder, child_process.SHAPE), "rb") as file:
        return job._replace(shape=file.read())


def description(error):
    fields = {name: getattr(error, name, None) for name in ("code", "remedy", "stage", "face", "edge", "point", "place")}
    return {"error": {"class": type(error).__name__, "text": str(error), **fields}}


def main(folder):
    if hasattr(os, "nice"):
        os.nice(NICENESS)
    messages, has_finished = take_output(), threading.Event()
    end_with_parent(folder, has_finished)

    def say(**message):
        messages.write(json.dumps(message) + "\n")

    try:
        job = read_job(folder)
        result = mesh_job.run(job, progress=lambda stage, fraction: say(stage=stage, fraction=fraction))
        say(stage="write", fraction=0.0)
        mesh_file.write(mesh_job.stored(job, result), os.path.join(folder, child_process.MESH))
        outcome = {"done": True}
    except core.load().Error as error:
        outcome = description(error)
    has_finished.set()
    say(**outcome)


if __name__ == "__main__":
    main(sys.argv[1])
