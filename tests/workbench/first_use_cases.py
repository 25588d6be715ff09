"""The add-on without its compiled core, in FreeCAD's window. first_use_test.py runs this in a copy of the add-on that
it may change; each class in a FreeCAD of its own, as a core that is loaded stays."""
import os
import shlex
import shutil
import sys
import unittest
import zipfile
from unittest import mock

import FreeCAD
import FreeCADGui
from PySide import QtGui

sys.path.append(os.path.join(os.path.dirname(os.path.dirname(os.path.realpath(__file__))), "support"))
import window
from paver_wb import binary, core, mesh_object
from paver_wb.gui import run_control
from paver_wb.gui.base import run_task
from paver_wb.gui.setup import core_build, first_use
from process import is_alive

WHEEL = os.environ.get("PAVER_WHEEL", "")  # a binary that fits
STEPS = """echo "[1/3] first"
sleep 600 &
echo $! > build.pid
wait
"""


def write_script(name, text):
    with open(core_build.script(name), "w") as file:
        file.write("#!/bin/bash\n" + text)


def read_number(path):
    """Of a file that may be about to be written; None without one."""
    try:
        with open(path) as file:
            return int(file.read())
    except (OSError, ValueError):
        return None


def changed_wheel(path, rename=lambda name: name, change=lambda data: data):
    """A copy of the wheel with other names or contents."""
    with zipfile.ZipFile(WHEEL) as old, zipfile.ZipFile(path, "w") as new:
        for name in old.namelist():
            new.writestr(rename(name), change(old.read(name)))
    return path


def damaged_wheel(path):
    """A copy of the wheel with other bytes in the middle of its compressed module."""
    with zipfile.ZipFile(WHEEL) as wheel:
        info = next(i for i in wheel.infolist() if i.filename.startswith("paver/_paver."))
    with open(WHEEL, "rb") as file:
        data = bytearray(file.read())
    middle = info.header_offset + info.compress_size // 2
    data[middle:middle + 1000] = bytes(byte ^ 0xff for byte in data[middle:middle + 1000])
    with open(path, "wb") as file:
        file.write(data)
    return path


def encrypted_wheel(path):
    """A copy of the wheel that says that its files are encrypted."""
    with zipfile.ZipFile(WHEEL) as wheel:
        infos, start = wheel.infolist(), wheel.start_dir
    with open(WHEEL, "rb") as file:
        data = bytearray(file.read())
    for info in infos:
        start = data.index(b"PK\1\2", start)
        data[start + 8] |= 1  # in the table of contents, and before the file
        data[info.header_offset + 6] |= 1
        start += 4
    with open(path, "wb") as file:
        file.write(data)
    return path


@unittest.skipUnless(WHEEL, "needs an add-on without a core, and a binary")
class WithDialog(unittest.TestCase):
    def setUp(self):
        self.assertNotEqual(core.problem(), "")
        FreeCADGui.activateWorkbench("PartWorkbench")
        FreeCADGui.activateWorkbench("PaverWorkbench")
        window.wait(lambda: window.widget("Paver_FirstUse"), "for the dialog")
        self.dialog = window.widget("Paver_FirstUse")
        self.addCleanup(self.dialog.close)
        self.folder = os.path.join(FreeCAD.getUserAppDataDir(), "cases")
        os.makedirs(self.folder, exist_ok=True)
        self.addCleanup(shutil.rmtree, self.folder)

    def button(self, name):
        return window.widget("Paver_FirstUse" + name, QtGui.QPushButton)

    def state(self):
        return window.widget("Paver_FirstUseState", QtGui.QLabel).text()

    def replace_script(self, name, text):
        with open(core_build.script(name)) as file:
            self.addCleanup(write_script, name, file.read())
        write_script(name, text)

    def mesh_everywhere(self):
        """The workbench works, here and in a process of its own; so do files."""
        document = FreeCAD.newDocument()
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        mesh = mesh_object.add(document, document.addObject("Part::Box"), size=3)
        document.recompute()
        for run_in in ("FreeCAD", "Own process"):
            run = run_control.start(mesh, run_in)
            window.wait(lambda: run.outcome, "for the mesh")
            self.assertEqual(run.outcome.kind, run_control.MESHED, run.outcome.text)
        self.assertEqual(mesh.Status, "Up to date")
        path = os.path.join(binary.checkout(), "Resources", "examples", "box.step")
        self.assertGreater(len(core.load().mesh(path, size=5).quads), 0)


class FirstUse(WithDialog):
    """What goes wrong, and what is said; no core comes of it."""

    def tearDown(self):
        self.assertNotEqual(core.problem(), "")
        self.assertFalse(os.path.exists(core.binary_folder()))

    def test_the_workbench_says_both_ways(self):
        window.picture("first_use")
        self.assertIn("is missing", self.state())
        self.assertIn("scripts/build paver_python", core.problem())
        self.assertIn("binary.install", core.problem())
        self.assertTrue(self.button("Build").isEnabled() and self.button("Choose").isEnabled())

    def test_a_command_that_needs_the_core_shows_it_again(self):
        self.dialog.close()
        document = FreeCAD.newDocument()
        self.addCleanup(FreeCAD.closeDocument, document.Name)
        box = document.addObject("Part::Box")
        FreeCADGui.Selection.addSelection(box)
        FreeCADGui.runCommand("Paver_CreateMesh")
        window.wait(lambda: window.widget("Paver_FirstUse"), "for the dialog")
        self.assertEqual(document.Objects, [box])

    def test_missing_packages_are_named_and_the_command_is_copied(self):
        self.replace_script("setup", 'test "$*" = "--missing build" && printf "cmake\\nlibocct-foundation-dev\\n"\n')
        self.dialog.look()
        window.picture("first_use_packages")
        self.assertFalse(self.button("Build").isEnabled())
        self.assertIn("cmake, libocct", window.widget("Paver_FirstUsePackages").text())
        window.click(self.button("Copy"))
        field = QtGui.QLineEdit()
        field.paste()
        self.assertEqual(field.text(), f"bash {shlex.quote(core_build.script('setup'))} build")
        write_script("setup", "exit 0\n")
        window.click(self.button("Again"))
        self.assertTrue(self.button("Build").isEnabled())
        self.assertIsNone(self.button("Again"))

    def test_where_packages_cannot_be_told_it_may_be_tried(self):
        self.replace_script("setup", "echo 'setup: this is not Debian.' >&2\nexit 1\n")
        self.dialog.look()
        self.assertIn("this is not Debian", window.widget("Paver_FirstUsePackages").text())
        self.assertTrue(self.button("Build").isEnabled())

    def test_numpy_is_all_that_is_asked_for_where_it_is_missing(self):
        with mock.patch.dict(sys.modules, {"numpy": None}):
            self.dialog.look()
            window.picture("first_use_numpy")
            self.assertIn("needs NumPy", self.state())
            self.assertIn("install it (package python3-numpy", self.state())
            self.assertNotIn("binary", core.problem())
            self.assertIsNone(self.button("Build") or self.button("Choose"))
        self.button("Again").click()  # a mouse event does not reach it here in FreeCAD 1.0
        self.assertIn("is missing", self.state())
        self.assertTrue(self.button("Build").isEnabled() and self.button("Choose").isEnabled())

    def test_nothing_is_built_for_another_python(self):
        with mock.patch.object(core_build, "PYTHON", os.path.join(self.folder, "python3")):
            with open(core_build.PYTHON, "w") as file:
                file.write("#!/bin/sh\necho 3.4\n")
            os.chmod(core_build.PYTHON, 0o755)
            self.addCleanup(core_build.built_for.cache_clear)
            core_build.built_for.cache_clear()
            self.dialog.look()
        window.picture("first_use_python")
        self.assertRegex(window.widget("Paver_FirstUsePackages").text(),
                         rf"Python 3\.4 .* Python {core_build.own_python()}\.")
        self.assertFalse(self.button("Build").isEnabled())
        self.assertTrue(self.button("Choose").isEnabled())

    def run_build(self, script):
        """Its log."""
        self.replace_script("build", script)
        self.button("Build").click()  # one mouse event in dozens does not reach it in FreeCAD 1.0
        window.wait(lambda: not run_task._tasks, "for the build")
        return self.dialog.log.toPlainText()

    def test_a_build_does_not_see_what_freecad_needs_for_itself(self):
        with mock.patch.dict(os.environ, {name: "/nowhere" for name in core_build.OF_FREECAD}):
            log = self.run_build(f"env | grep -E '^({'|'.join(core_build.OF_FREECAD)})='\necho all\nexit 1\n")
        self.assertEqual(log.splitlines()[1:], ["all"])

    def test_the_log_has_every_letter_and_the_last_line(self):
        log = self.run_build("printf 'gr\\303'\nsleep 1\nprintf '\\274n\\nohne Ende \\303\\244'\nexit 1\n")
        self.assertEqual(log.splitlines()[1:], ["grün", "ohne Ende ä"])

    def test_a_build_that_fails_shows_why(self):
        log = self.run_build("echo '[1/2] first'\necho 'no such compiler' >&2\nexit 3\n")
        self.assertIn("failed", self.state())
        self.assertIn("no such compiler", log)
        self.assertTrue(self.button("Build").isEnabled())

    def test_a_build_is_stopped_with_all_its_processes_and_goes_on(self):
        self.replace_script("build", STEPS)
        path = os.path.join(binary.checkout(), "build.pid")
        for _ in range(2):
            window.click(self.button("Build"))
            self.assertFalse(self.button("Build").isEnabled() or self.button("Choose").isEnabled())
            window.wait(lambda: read_number(path) and self.dialog.build.percent() == 33, "for the build")
            child = read_number(path)
            self.assertTrue(is_alive(child))
            window.picture("first_use_build")
            self.dialog.close()  # it goes on
            window.pause(200)
            self.assertTrue(is_alive(child) and window.widget("PaverStatusStop") is not None)
            first_use.show()
            window.click(self.button("Stop"))
            window.wait(lambda: not run_task._tasks, "for the end")
            self.assertFalse(is_alive(child))
            self.assertIn("stopped", self.state())
            os.remove(path)

    def refuse(self, path, *words):
        self.dialog.unpack(path)
        window.wait(lambda: not self.dialog.is_busy(), "for the binary")
        for word in words:
            self.assertIn(word, self.state())
        self.assertEqual(self.state().count(". "), 0, self.state())
        above = os.path.dirname(core.binary_folder())
        self.assertEqual(os.listdir(above) if os.path.isdir(above) else [], [])

    def test_binaries_that_do_not_fit_are_refused_in_one_sentence(self):
        path = os.path.join(self.folder, "paver.whl")
        version = binary.own_version()
        other = ".".join("9" * len(part) for part in version.split("."))
        module = next(n for n in zipfile.ZipFile(WHEEL).namelist() if n.startswith("paver/_paver."))

        def old(data):
            return data.replace(b"module, version " + version.encode(), b"module, version " + other.encode())
        self.refuse(os.path.join(self.folder, "none.whl"), "cannot be read", "choose a file paver-" + version)
        self.refuse(changed_wheel(path, change=old), f"has version {other}", f"has version {version}")
        self.refuse(changed_wheel(path, lambda name: name.replace(module, "paver/_paver.cpython-27-alpha.so")),
                    "another Python", "cpython-27-alpha")
        self.refuse(changed_wheel(path, lambda name: "pa" + name), "no compiled module")
        with open(WHEEL, "rb") as file, open(path, "wb") as cut:
            cut.write(file.read()[:100000])
        self.refuse(path, "cannot be read")
        self.refuse(damaged_wheel(path), "cannot be read", "that is whole")
        self.refuse(encrypted_wheel(path), "cannot be read", "encrypted", "that is whole")
        self.refuse(changed_wheel(path, change=lambda data: data.replace(b"libTKernel", b"libTKnever")),
                    "does not load on this machine", "libTKnever", "build Paver here")
        with zipfile.ZipFile(shutil.copy(WHEEL, path), "a") as wheel:
            wheel.writestr("numpy.py", "raise ImportError")
        self.refuse(path, "does not load on this machine: Paver needs NumPy", "install it (package python3-numpy")
        self.assertNotIn("build Paver", self.state())


class FirstUseBinary(WithDialog):
    def test_a_binary_in_freecads_folder_is_offered_and_works_at_once(self):
        with open(os.path.join(FreeCAD.getUserAppDataDir(), "paver-0-other.whl"), "wb") as other:
            other.write(b"nothing")
        damaged_wheel(os.path.join(FreeCAD.getUserAppDataDir(), "paver-0-damaged.whl"))
        shutil.copy(WHEEL, FreeCAD.getUserAppDataDir())
        self.dialog.look()
        window.picture("first_use_binary")
        self.assertIn(os.path.basename(WHEEL), window.widget("Paver_FirstUseWheel").text())
        window.click(self.button("Use"))
        window.wait(lambda: not self.dialog.is_busy(), "for the binary")
        self.assertEqual(core.problem(), "")
        self.assertTrue(core.load()._paver.__file__.startswith(core.binary_folder()))
        self.assertEqual(os.listdir(os.path.dirname(core.binary_folder())), ["binary"])
        window.picture("first_use_ready")
        self.assertIn("ready", self.state())
        self.assertTrue(self.button("Build") is None and self.button("Choose") is None)
        self.mesh_everywhere()
        self.replace_binary()

    def replace_binary(self):
        """Another one over that of before, which stays where that fails; what an end of FreeCAD left goes."""
        above = os.path.dirname(core.binary_folder())
        os.makedirs(os.path.join(above, "unpacking-of-yore", "paver"))
        mark = os.path.join(core.binary_folder(), "of before")
        open(mark, "w").close()
        real = os.rename

        def rename(old, new):
            if new == core.binary_folder() and not old.endswith("-before"):
                raise OSError("no such luck")
            real(old, new)
        with mock.patch("os.rename", rename):
            with self.assertRaisesRegex(ValueError, "cannot be unpacked .*no such luck.*check"):
                binary.install(WHEEL)
        self.assertTrue(os.path.exists(mark))
        self.assertEqual(os.listdir(above), ["binary"])
        binary.install(WHEEL)
        self.assertFalse(os.path.exists(mark))
        self.assertEqual(os.listdir(above), ["binary"])


class FirstUseBuild(WithDialog):
    def test_what_is_built_here_works_at_once(self):
        with zipfile.ZipFile(WHEEL) as wheel:
            wheel.extractall(self.folder)
        libraries = os.path.join(self.folder, "paver.libs")  # which a binary may bring along
        os.makedirs(libraries, exist_ok=True)
        self.replace_script("build", 'test "$*" = paver_python || exit 2\nmkdir -p build/bindings\n'
                            'echo "[1/2] a"\nsleep 1\n'
                            f"cp -r {libraries} build\ncp {self.folder}/paver/*.so build/bindings\necho '[2/2] b'\n")
        window.click(self.button("Build"))
        window.wait(lambda: not run_task._tasks, "for the build")
        self.assertEqual(core.problem(), "")
        self.assertTrue(core.load()._paver.__file__.startswith(os.path.join(binary.checkout(), "build")))
        self.mesh_everywhere()
