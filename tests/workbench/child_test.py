"""A meshing process does not outlive FreeCAD, however that ends."""
import os
import signal
import subprocess
import time

import freecad_program

START = """import os, sys, tempfile, FreeCAD
from paver_wb import mesh_object, meshing
from paver_wb.processes import child_process
document = FreeCAD.newDocument()
mesh = mesh_object.add(document, document.addObject("Part::Box"), size=0.01, max_elements=100000000)
document.recompute()
folder = tempfile.mkdtemp(prefix="paver", dir=os.path.dirname(document.TransientDir))


def progress(stage, fraction):
    with open(sys.argv[-1] + ".new", "w") as file:
        file.write(folder)
    os.replace(sys.argv[-1] + ".new", sys.argv[-1])


child_process.run(meshing.prepare(mesh), folder, progress)
"""


def wait(is_done, seconds=60):
    end = time.monotonic() + seconds
    while not is_done():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.05)


def processes_of(folder):
    """Ids of the processes that were started with `folder` as an argument."""
    found = []
    for entry in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{entry}/cmdline", "rb") as file:
                if os.fsencode(folder) in file.read().split(b"\0"):
                    found.append(int(entry))
        except OSError:
            pass
    return found


def test_child_goes_with_a_killed_freecad(home, tmp_path):
    macro, told = tmp_path / "start.FCMacro", tmp_path / "folder"
    macro.write_text(START)
    parent = subprocess.Popen([freecad_program.program(), str(macro), "--", str(told)], stdin=subprocess.DEVNULL, cwd=home,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              env={**os.environ, "FREECAD_USER_HOME": home})
    try:
        wait(lambda: told.exists() or parent.poll() is not None)
        folder = told.read_text()
        assert processes_of(folder)
    finally:
        parent.send_signal(signal.SIGKILL)
        parent.wait()
    wait(lambda: not processes_of(folder))
    assert not os.path.exists(folder)
