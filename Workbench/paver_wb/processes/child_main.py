"""The program of a process that does one job for FreeCAD: child_main.py FOLDER; see child_process.py."""
import json
import os
import shutil
import sys
import threading

from paver_wb import core
from paver_wb.formats import mesh_file
from paver_wb.processes import child_process, mesh_job, model_look

NICENESS = 5  # FreeCAD's window comes first


def take_output():
    """A file for events only: whatever else writes to the output ends up in the log."""
    events = os.fdopen(os.dup(1), "w", encoding="utf-8", buffering=1)
    os.dup2(2, 1)
    return events


def end_with_parent(folder, has_finished):
    """Ends this process when FreeCAD closes its input, as it does also by dying, and leaves no files behind then."""
    def wait():
        while os.read(0, 4096):
            pass
        if not has_finished.is_set():
            shutil.rmtree(folder, ignore_errors=True)
            os._exit(1)
    threading.Thread(target=wait, daemon=True).start()


def job_of(content):
    with open(content["input"], "rb") as file:
        return mesh_job.Job(file.read(), content["name"], content["labels"], content["options"], content["sources"], "", "")


def mesh(content, say):
    """The mesh of a shape."""
    job = job_of(content)

    def tell(stage, fraction):
        say(event="progress", stage=stage, percent=int(100 * fraction))
    mesh_job.store(job, content["mesh"], tell)


def convert(content):
    """A mesh into a file of FreeCAD's formats, or out of one; or what is seen of a shape before it is meshed."""
    sys.path.extend(folder for folder in content["folders"] if folder not in sys.path)
    import FreeCAD  # noqa: F401, before any of its modules
    if "options" in content:
        model_look.save(model_look.look(job_of(content)), content["mesh"])
        return
    from paver_wb.formats import fem_mesh, raw_mesh, read_fem
    if "groups" in content:
        fem_mesh.write(mesh_file.read(content["input"]), content["groups"], content["mesh"])
    else:
        raw_mesh.save(read_fem.tables(content["input"]), content["mesh"])


def error_event(error):
    fields = {name: getattr(error, name, None) for name in ("remedy", "stage", "face", "edge", "point", "place")}
    return {"event": "error", "code": getattr(error, "code", type(error).__name__),
            "sentence": str(error).strip() or type(error).__name__, **fields}


def main(folder):
    if hasattr(os, "nice"):
        os.nice(NICENESS)
    events, has_finished = take_output(), threading.Event()
    end_with_parent(folder, has_finished)

    def say(**event):
        events.write(json.dumps(event) + "\n")
    os.chdir(folder)
    with open(child_process.JOB, encoding="utf-8") as file:
        content = json.load(file)
    outcome = {"event": "done"}
    try:
        convert(content) if "folders" in content else mesh(content, say)
    except Exception as error:
        if "folders" not in content and not isinstance(error, core.load().Error):
            raise  # a fault of ours: the log tells
        outcome = error_event(error)
    has_finished.set()
    say(**outcome)
    events.flush()
    os._exit(0)  # FreeCAD's own end has nothing to save here


if __name__ == "__main__":
    main(sys.argv[1])
