"""The program of a process that reads or writes a file with FreeCAD's modules: fem_child.py FOLDER; see fem_process.py."""
import json
import os
import sys
import threading

import numpy as np

from paver_wb import child_main, fem_mesh, fem_process, mesh_file, read_fem


def do(task, folder):
    if "write" in task:
        fem_mesh.write(mesh_file.read(task["write"]), task["groups"], task["path"])
    else:
        made = read_fem.tables(task["read"])
        np.savez(os.path.join(folder, fem_process.TABLES), order=made.order, names=np.array(made.names, dtype=str),
                 **{name: getattr(made, name) for name in fem_process.ARRAYS})


def main(folder):
    messages, has_finished = child_main.take_output(), threading.Event()
    child_main.end_with_parent(folder, has_finished)
    with open(os.path.join(folder, fem_process.TASK), encoding="utf-8") as file:
        task = json.load(file)
    sys.path.extend(folder for folder in task["folders"] if folder not in sys.path)
    import FreeCAD  # noqa: F401, before any of its modules
    try:
        do(task, folder)
        outcome = {"done": True}
    except Exception as error:
        outcome = {"error": str(error).strip() or type(error).__name__, "class": type(error).__name__}
    has_finished.set()
    messages.write(json.dumps(outcome) + "\n")
    messages.flush()
    os._exit(0)  # FreeCAD's own end has nothing to save here


if __name__ == "__main__":
    main(sys.argv[1])
