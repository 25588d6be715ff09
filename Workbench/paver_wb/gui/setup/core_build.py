"""Building the core from the window: which packages are missing, and the build as a process that can be stopped."""
import functools
import os
import re
import shlex
import subprocess
import sys

from PySide import QtCore

from paver_wb import binary
from paver_wb.gui.base import run_task
from paver_wb.gui.base.widgets import translate
from paver_wb.processes import child_process

PATIENCE = 3  # seconds until processes that were asked to end are killed
STEP = re.compile(r"^\[(\d+)/(\d+)\] ")  # how ninja begins a line
PYTHON = "/usr/bin/python3"  # for which scripts/build builds
OF_FREECAD = ("PYTHONHOME", "PYTHONPATH", "LD_LIBRARY_PATH")  # for itself, where it brings its own libraries


def script(name):
    return os.path.join(binary.checkout(), "scripts", name)


def environment(**more):
    return {**{name: value for name, value in os.environ.items() if name not in OF_FREECAD}, **more}


def said_by(*command):
    """CompletedProcess of a program of the system's."""
    return subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, env=environment())


@functools.lru_cache(maxsize=None)
def built_for():
    """Version of the Python that a build is for, as "3.11"; empty without one."""
    try:
        return said_by(PYTHON, "-c", "import sys; print('{}.{}'.format(*sys.version_info))").stdout.strip()
    except OSError:
        return ""


def own_python():
    return "{}.{}".format(*sys.version_info)


def missing_packages():
    """Debian packages that the build needs and that are not installed. ValueError where that cannot be told."""
    done = said_by("bash", script("setup"), "--missing", "build")
    if done.returncode:
        raise ValueError(done.stderr.strip())
    return done.stdout.split()


def command():
    """What installs them, in a terminal."""
    return f"bash {shlex.quote(script('setup'))} build"


class Failed(Exception):
    """The build has ended without a core."""


class Build(run_task.Task):
    """One run of scripts/build. It goes on beside the window; what is compiled is there for the next one when it is
    stopped."""

    said = QtCore.Signal(str)  # lines for the log

    def __init__(self):
        super().__init__(translate("Paver", "Building Paver"), None, Build.work, lambda _: None)
        self.thread.patience = 3000 * PATIENCE

    def work(self):
        """On the thread."""
        variables = environment(NINJA_STATUS="[%f/%t] ")
        variables.pop("PAVER_BUILD", None)
        arguments = ["nice", "-n", "5", "bash", script("build"), "paver_python"]
        if child_process.supervise(arguments, binary.checkout(), self.say, self.cancel, variables, patience=PATIENCE):
            raise Failed

    def say(self, line):
        step = STEP.match(line)
        if step:
            self.tell("build", int(step.group(1)) / max(1, int(step.group(2))))
        self.said.emit(line)

    @QtCore.Slot()
    def leave(self):
        """Never: another build at once would meet its processes in the build folder."""

    def told(self, how):
        return how
