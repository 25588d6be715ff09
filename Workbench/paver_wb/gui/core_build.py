"""Building the core from the window: which packages are missing, and the build as a process that can be stopped."""
import codecs
import functools
import os
import re
import shlex
import signal
import subprocess
import sys
import time

import FreeCAD
from PySide import QtCore

from paver_wb import binary

BUILT, FAILED, STOPPED = "built", "failed", "stopped"
PATIENCE, LOOK = 3000, 50  # ms until processes that were asked to end are killed; between looks whether they have gone
STEP = re.compile(r"^\[(\d+)/(\d+)\] ")  # how ninja begins a line
PYTHON = "/usr/bin/python3"  # for which scripts/build builds
OF_FREECAD = ("PYTHONHOME", "PYTHONPATH", "LD_LIBRARY_PATH")  # for itself, where it brings its own libraries
translate = FreeCAD.Qt.translate
_builds = []  # those that have not ended


def script(name):
    return os.path.join(binary.checkout(), "scripts", name)


def said_by(*command):
    """CompletedProcess of a program of the system's."""
    return subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL,
                          env={name: value for name, value in os.environ.items() if name not in OF_FREECAD})


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


class Build(QtCore.QObject):
    """One run of scripts/build. It goes on beside the window; what is compiled is there for the next one when it is
    stopped. `outcome` is None, BUILT, FAILED or STOPPED."""

    progressed = QtCore.Signal(str, float)
    said = QtCore.Signal(str)  # lines for the log
    ended = QtCore.Signal(object)

    def __init__(self):
        super().__init__()
        self.outcome, self.fraction, self.is_stopped, self.rest = None, None, False, ""
        self.group = 0
        self.decoder = codecs.getincrementaldecoder("utf-8")("replace")
        self.process = QtCore.QProcess()
        self.process.setProcessChannelMode(QtCore.QProcess.MergedChannels)
        self.process.setWorkingDirectory(binary.checkout())
        self.process.readyRead.connect(self.read)
        self.process.finished.connect(self.finish)
        self.process.errorOccurred.connect(self.fail_to_start)
        variables = QtCore.QProcessEnvironment.systemEnvironment()
        variables.insert("NINJA_STATUS", "[%f/%t] ")
        for name in ("PAVER_BUILD", *OF_FREECAD):
            variables.remove(name)
        self.process.setProcessEnvironment(variables)

    def begin(self):
        """In a group of processes of its own, so that all of them can be ended."""
        _builds.append(self)
        self.process.start("setsid", ["nice", "-n", "5", "bash", script("build"), "paver_python"])
        self.group = self.process.processId()
        self.process.closeWriteChannel()

    def line(self):
        return translate("Paver", "Building Paver")

    def percent(self):
        return None if self.fraction is None else int(100 * self.fraction)

    @QtCore.Slot()
    def read(self):
        self.tell(self.decoder.decode(bytes(self.process.readAll())))

    def tell(self, text):
        """Whole lines; the rest waits for its end."""
        *lines, self.rest = (self.rest + text).split("\n")
        for line in lines:
            step = STEP.match(line)
            if step:
                self.fraction = int(step.group(1)) / max(1, int(step.group(2)))
                self.progressed.emit("build", self.fraction)
            self.said.emit(line)

    def stop(self):
        """`ended` comes when no process of the build is left: another one at once would meet them in the build
        folder."""
        self.is_stopped = True
        self.signal(signal.SIGTERM)
        QtCore.QTimer.singleShot(PATIENCE, lambda: self.signal(signal.SIGKILL))
        QtCore.QTimer.singleShot(2 * PATIENCE, lambda: self.end(STOPPED))
        self.look()

    def signal(self, which):
        """To all processes of the build; whether there are some. A group lives as long as its last process."""
        if self.outcome is not None:
            return False
        try:
            os.killpg(self.group, which)
        except ProcessLookupError:
            if self.process.state() == QtCore.QProcess.NotRunning:
                return False
            self.process.kill()  # it has no group yet
        return True

    def look(self):
        """Whether the processes that were asked to end have gone."""
        if self.signal(0):
            QtCore.QTimer.singleShot(LOOK, self.look)
        else:
            self.end(STOPPED)

    @QtCore.Slot(int, QtCore.QProcess.ExitStatus)
    def finish(self, code, status):
        self.read()
        rest = self.rest + self.decoder.decode(b"", True)
        if rest:
            self.said.emit(rest)
        if not self.is_stopped:
            self.end(BUILT if code == 0 and status == QtCore.QProcess.NormalExit else FAILED)

    @QtCore.Slot(QtCore.QProcess.ProcessError)
    def fail_to_start(self, error):
        if error == QtCore.QProcess.FailedToStart:
            self.said.emit(self.process.errorString())
            self.end(FAILED)

    def end(self, outcome):
        if self.outcome is None:
            self.outcome = outcome
            _builds.remove(self)
            self.ended.emit(outcome)


def running():
    """The Build that is at work, or None."""
    return _builds[0] if _builds else None


def end_all():
    """For the end of the program: no process stays behind."""
    for build in list(_builds):
        build.is_stopped = True
        for which in (signal.SIGTERM, signal.SIGKILL):
            end = time.monotonic() + PATIENCE / 1000
            is_there = build.signal(which)
            while is_there and time.monotonic() < end:
                build.process.waitForFinished(LOOK)
                is_there = build.signal(0)


QtCore.QCoreApplication.instance().aboutToQuit.connect(end_all)
