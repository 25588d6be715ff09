"""The add-on as FreeCAD's Addon Manager installs it, which copies files and runs nothing; then the first use of it."""
import os
import re
import shutil
import subprocess
import time

import built_wheel
import freecad_program
import pytest

import repo
from process import is_alive

# Installs from a repository or an archive, in FreeCAD, as the Addon Manager of its version does.
INSTALL = """import os, sys, traceback
import FreeCAD
from Addon import Addon
method, url = sys.argv[-2:]
addon, said = Addon("Paver", url, Addon.Status.NOT_INSTALLED, "main"), []
target = os.path.join(FreeCAD.getUserAppDataDir(), "Mod", "Paver")


def install():
    try:
        import addonmanager_installer as manager
    except ImportError:
        return install_by_worker()
    installer = manager.AddonInstaller(addon, [])
    installer.failure.connect(lambda _addon, text: said.append(text))
    installer.run(getattr(manager.InstallationMethod, method.upper()))


def install_by_worker():  # before FreeCAD 0.21
    import addonmanager_workers as manager
    worker = manager.InstallWorkbenchWorker(addon)
    worker.failure.connect(lambda _addon, text: said.append(text))
    if method == "git":
        worker.run_git(target)
    else:
        os.makedirs(target)
        worker.zipdir, worker.bakdir = target, None
        worker.finish_zip(0, 200, url)


try:
    install()
    needed = Addon.Dependencies()
    addon.walk_dependency_tree({}, needed)
    print("made:", said, addon.url == url, addon.branch, sorted(needed.internal_workbenches),
          sorted(getattr(needed, "python_requires", None) or needed.python_required), flush=True)
except BaseException:
    traceback.print_exc()
    sys.stderr.flush()
os._exit(0)
"""

# Begins a build and ends FreeCAD, as a user who closes its window.
CLOSE = """import os, sys, traceback
import FreeCAD, FreeCADGui
from PySide import QtCore


def begin():
    try:
        import TestPaver, first_use_cases, window
        from paver_wb import binary
        from paver_wb.gui.setup import first_use
        first_use_cases.write_script("build", first_use_cases.STEPS)
        first_use.show().begin()
        path = os.path.join(binary.checkout(), "build.pid")
        window.wait(lambda: first_use_cases.read_number(path), "for the build")
        print("child:", first_use_cases.read_number(path), flush=True)
        FreeCADGui.getMainWindow().close()
    except BaseException:
        traceback.print_exc()
        os._exit(1)


QtCore.QTimer.singleShot(1000, begin)
"""


@pytest.fixture(scope="module")
def source(tmp_path_factory):
    """A repository with the files of this checkout, on a branch main, and an archive of it as hosts make them."""
    folder = tmp_path_factory.mktemp("source") / "Paver"
    for name in repo.files():
        os.makedirs(os.path.dirname(folder / name), exist_ok=True)
        shutil.copy2(os.path.join(repo.ROOT, name), folder / name)
    git = ["git", "-C", str(folder), "-c", "user.name=Paver", "-c", "user.email=noreply@paver.invalid"]
    for arguments in (["init", "-q", "-b", "main"], ["add", "-A"], ["commit", "-qm", "All"],
                      ["archive", "--format=zip", "--prefix=Paver.zip-main/", "-o", str(folder) + ".zip", "main"]):
        subprocess.run(git + arguments, check=True, capture_output=True)
    return folder


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """A binary: the one that PAVER_WHEEL names, else of what is built."""
    return os.environ.get("PAVER_WHEEL") or built_wheel.make(tmp_path_factory.mktemp("wheel"))


@pytest.fixture
def empty_home(home, tmp_path):
    """A profile of FreeCAD without the add-on."""
    folder = tmp_path / "empty"
    folder.mkdir()
    return str(folder)


def install(home, method, url):
    """Installs into the profile; what the manager made of package.xml."""
    macro = os.path.join(home, "install.FCMacro")
    with open(macro, "w") as file:
        file.write(INSTALL)
    done = freecad_program.run([macro, "--", method, str(url)], home)
    made = [line for line in done.stdout.splitlines() if line.startswith("made:")]
    assert made, done.stdout + done.stderr
    return made[0]


@pytest.fixture
def installed(empty_home, source):
    install(empty_home, "git", source.as_uri())
    return empty_home


@pytest.mark.parametrize("method", ["git", "zip"])
def test_the_addon_manager_installs_it(empty_home, source, method):
    url = source.as_uri() if method == "git" else str(source) + ".zip"
    assert install(empty_home, method, url) == "made: [] True main ['FEM', 'Part'] ['numpy']"
    script = os.path.join(empty_home, "Mod", "Paver", "scripts", "build")
    command = "scripts/build" if os.access(script, os.X_OK) else "bash scripts/build"
    done = freecad_program.run(["-c", "from paver_wb import core; print('said:', core.problem(), flush=True)"], empty_home,
                       PAVER_BUILD="")
    said = done.stdout.split("said:")[1].split("\n")[0]
    assert f"is missing; run {command} paver_python in" in said and "binary.install(" in said, done.stdout
    assert "Traceback" not in done.stdout + done.stderr


@pytest.mark.parametrize("case, count", [("FirstUse", 11), ("FirstUseBinary", 1), ("FirstUseBuild", 1)])
def test_first_use_in_the_window(installed, wheel, case, count):
    done = freecad_program.run_window(["-t", "TestPaverGui." + case], installed, PAVER_BUILD="", PAVER_WHEEL=str(wheel))
    output = done.stdout + done.stderr
    assert done.returncode == 0, output[-8000:]
    assert int(re.search(r"Ran (\d+) tests?", output).group(1)) >= count and "skipped" not in output
    assert "already deleted" not in output and "Traceback" not in output, output[-8000:]


def test_a_binary_is_found_without_a_window_and_at_the_next_start(installed, wheel):
    lines = ["from paver_wb import binary, core", f"binary.install({str(wheel)!r})", "print('made:', core.problem())"]
    for script in ("; ".join(lines), "import paver; print('made:', paver.mesh(__import__('Part').makeBox(1, 1, 1), size=1))"):
        done = freecad_program.run(["-c", script + "; import sys; sys.stdout.flush()"], installed, PAVER_BUILD="")
        assert "made:" in done.stdout and "Traceback" not in done.stderr, done.stdout + done.stderr
    assert "quads" in done.stdout.split("made:")[1], done.stdout


def test_a_build_ends_with_freecad(installed, tmp_path):
    macro = tmp_path / "close.FCMacro"
    macro.write_text(CLOSE)
    done = freecad_program.run_window([str(macro)], installed, PAVER_BUILD="")
    child = re.search(r"child: (\d+)", done.stdout)
    assert child, done.stdout + done.stderr
    end = time.monotonic() + 30
    while is_alive(child.group(1)) and time.monotonic() < end:
        time.sleep(0.1)
    assert not is_alive(child.group(1))
