"""scripts/install links the checkout into a private user folder of FreeCAD, and takes it away again."""
import os
import shutil
import subprocess
import tempfile
import unittest

import pytest

import repo

INSTALL = os.path.join(repo.ROOT, "scripts", "install")


@pytest.mark.usefixtures("home")  # which skips without FreeCAD
class Install(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.home, self.link = folder.name, os.path.join(folder.name, "Mod", "Paver")

    def install(self, *arguments, script=(INSTALL,), **environment):
        done = subprocess.run([*script, *arguments], capture_output=True, text=True, stdin=subprocess.DEVNULL,
                              timeout=120, env={**os.environ, "FREECAD_USER_HOME": self.home, **environment})
        return done.returncode, done.stdout, done.stderr

    def test_links_once_and_again_and_freecad_finds_the_add_on(self):
        for _ in range(2):
            code, output, errors = self.install("--link-only")
            self.assertEqual(code, 0, errors)
            self.assertEqual(os.path.realpath(self.link), os.path.realpath(repo.ROOT))
            self.assertIn("\nPaver 0.", output)
        self.assertEqual(self.install("--remove")[0], 0)
        self.assertFalse(os.path.lexists(self.link))
        self.assertTrue(os.path.exists(INSTALL))
        code, _, errors = self.install("--remove")
        self.assertEqual((code, "nothing to remove" in errors), (1, True))

    def test_says_so_where_the_core_is_missing(self):
        code, output, _ = self.install("--link-only", PAVER_BUILD=self.home)
        self.assertEqual(code, 1)
        self.assertIn("run scripts/build paver_python", output)

    def test_a_folder_of_the_user_is_left_alone(self):
        os.makedirs(os.path.join(self.link, "precious"))
        for arguments in (["--link-only"], ["--remove"]):
            code, _, errors = self.install(*arguments)
            self.assertEqual((code, "not a link" in errors), (1, True))
        self.assertTrue(os.path.isdir(os.path.join(self.link, "precious")))

    def test_a_checkout_that_lies_there_is_taken_as_it_is(self):
        """FreeCAD's Addon Manager copies it there; archives lose the permission to run."""
        for name in repo.files():
            if not name.startswith(("tests", "core", "Resources")):
                os.makedirs(os.path.dirname(os.path.join(self.link, name)), exist_ok=True)
                shutil.copyfile(os.path.join(repo.ROOT, name), os.path.join(self.link, name))
        script = ["bash", os.path.join(self.link, "scripts", "install")]
        build = os.environ.get("PAVER_BUILD") or os.path.join(repo.ROOT, "build")
        code, output, errors = self.install("--link-only", script=script, PAVER_BUILD=build)
        self.assertEqual(code, 0, output + errors)
        self.assertIn(f"{self.link} is this checkout", output)
        self.assertIn("\nPaver 0.", output)
        code, _, errors = self.install("--remove", script=script)
        self.assertEqual((code, "Addon Manager" in errors), (1, True))
        self.assertTrue(os.path.isfile(script[1]))

    def test_says_before_it_builds_that_freecad_is_missing(self):
        code, output, errors = self.install(FREECAD_PROGRAM="no-such-program")
        self.assertEqual((code, output, "no program no-such-program" in errors), (1, "", True))

    def test_another_checkout_is_replaced_but_not_removed(self):
        os.makedirs(os.path.dirname(self.link))
        os.symlink("/nowhere/paver", self.link)
        code, _, errors = self.install("--remove")
        self.assertEqual((code, "/nowhere/paver" in errors), (1, True))
        self.assertEqual(self.install("--link-only")[0], 0)
        self.assertEqual(os.path.realpath(self.link), os.path.realpath(repo.ROOT))

    def test_another_folder_and_another_program(self):
        mod = os.path.join(self.home, "other")
        self.assertEqual(self.install("--link-only", FREECAD_MOD=mod)[0], 0)
        self.assertTrue(os.path.islink(os.path.join(mod, "Paver")))
        code, _, errors = self.install("--link-only", FREECAD_PROGRAM="no-such-program")
        self.assertEqual((code, "no program no-such-program" in errors), (1, True))
        self.assertEqual(self.install("--unknown")[0], 2)
