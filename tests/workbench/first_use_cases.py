"""The add-on without its compiled core, in FreeCAD's window. first_use_test.py runs this in a copy of the add-on that it
may change; each class in a FreeCAD of its own, as a core that is loaded stays."""
import os
import shutil
import unittest
import zipfile

import FreeCAD
import FreeCADGui
from PySide import QtGui

import window
from paver_wb import binary, core, mesh_object
from paver_wb.gui import core_build, first_use, run_control

WHEEL = os.environ.get("PAVER_WHEEL", "")  # a binary that fits
STEPS = """echo "[1/3] first"
sleep 600 &
echo $! > build.pid
wait
"""


def is_alive(process):
    try:
        with open(f"/proc/{process}/stat") as file:
            return file.read().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


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
        self.assertEqual(field.text(), "sudo apt-get install --no-install-recommends cmake libocct-foundation-dev")
        write_script("setup", "exit 0\n")
        window.click(self.button("Again"))
        self.assertTrue(self.button("Build").isEnabled())
        self.assertIsNone(self.button("Again"))

    def test_where_packages_cannot_be_told_it_may_be_tried(self):
        self.replace_script("setup", "echo 'setup: this is not Debian.' >&2\nexit 1\n")
        self.dialog.look()
        self.assertIn("this is not Debian", window.widget("Paver_FirstUsePackages").text())
        self.assertTrue(self.button("Build").isEnabled())

    def test_a_build_that_fails_shows_why(self):
        self.replace_script("build", "echo '[1/2] first'\necho 'no such compiler' >&2\nexit 3\n")
        window.click(self.button("Build"))
        window.wait(lambda: core_build.running() is None, "for the build")
        self.assertIn("failed", self.state())
        self.assertIn("no such compiler", self.dialog.log.toPlainText())
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
            window.wait(lambda: core_build.running() is None, "for the end")
            self.assertFalse(is_alive(child))
            self.assertIn("stopped", self.state())
            os.remove(path)

    def refuse(self, path, *words):
        self.dialog.unpack(path)
        window.wait(lambda: self.dialog.unpacking is None, "for the binary")
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
        self.refuse(changed_wheel(path, change=lambda data: data.replace(b"libTKernel", b"libTKnever")),
                    "does not load on this machine", "libTKnever")


class FirstUseBinary(WithDialog):
    def test_a_binary_in_freecads_folder_is_offered_and_works_at_once(self):
        with open(os.path.join(FreeCAD.getUserAppDataDir(), "paver-0-other.whl"), "wb") as other:
            other.write(b"nothing")
        shutil.copy(WHEEL, FreeCAD.getUserAppDataDir())
        self.dialog.look()
        window.picture("first_use_binary")
        self.assertIn(os.path.basename(WHEEL), window.widget("Paver_FirstUseWheel").text())
        window.click(self.button("Use"))
        window.wait(lambda: self.dialog.unpacking is None, "for the binary")
        self.assertEqual(core.problem(), "")
        self.assertTrue(core.load()._paver.__file__.startswith(core.binary_folder()))
        self.assertEqual(os.listdir(os.path.dirname(core.binary_folder())), ["binary"])
        window.picture("first_use_ready")
        self.assertIn("ready", self.state())
        self.assertTrue(self.button("Build") is None and self.button("Choose") is None)
        self.mesh_everywhere()
        binary.install(WHEEL)  # again, over that of before
        self.assertEqual(os.listdir(os.path.dirname(core.binary_folder())), ["binary"])


class FirstUseBuild(WithDialog):
    def test_what_is_built_here_works_at_once(self):
        with zipfile.ZipFile(WHEEL) as wheel:
            wheel.extractall(self.folder)
        libraries = os.path.join(self.folder, "paver.libs")  # which a binary may bring along
        os.makedirs(libraries, exist_ok=True)
        self.replace_script("build", 'test "$*" = paver_python || exit 2\nmkdir -p build/bindings\necho "[1/2] a"\nsleep 1\n'
                            f"cp -r {libraries} build\ncp {self.folder}/paver/*.so build/bindings\necho '[2/2] b'\n")
        window.click(self.button("Build"))
        window.wait(lambda: core_build.running() is None, "for the build")
        self.assertEqual(core.problem(), "")
        self.assertTrue(core.load()._paver.__file__.startswith(os.path.join(binary.checkout(), "build")))
        self.mesh_everywhere()
