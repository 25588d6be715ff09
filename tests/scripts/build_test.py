"""scripts/build and scripts/setup where something is missing, or a build was configured elsewhere; nothing is compiled."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import repo  # noqa: E402

TOOLS = ("awk", "bash", "cat", "cut", "dirname", "flock", "grep", "id", "mkdir", "mv", "nproc", "rm", "sed", "sort", "touch", "tr")
PACKAGES = """# Packages.

# build: all
cmake
g++
# test: tests
xvfb
cmake
"""


class Scripts(unittest.TestCase):
    def setUp(self):
        self.folder = os.path.join(self.enterContext(tempfile.TemporaryDirectory()), "Paver")
        self.tools = os.path.join(self.folder, "tools")
        os.makedirs(self.tools)
        for tool in TOOLS:
            os.symlink(shutil.which(tool), os.path.join(self.tools, tool))
        for name in ("build", "setup"):
            os.makedirs(os.path.join(self.folder, "scripts"), exist_ok=True)
            shutil.copy(os.path.join(repo.ROOT, "scripts", name), os.path.join(self.folder, "scripts"))
        self.write("scripts/packages.txt", PACKAGES)
        self.write("CMakeLists.txt", "")
        self.tool("apt-get", "echo installing >&2; exit 1")
        self.tool("dpkg-query", "echo 'ii g++'")

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w") as file:
            file.write(text)
        return path

    def tool(self, name, script):
        os.chmod(self.write("tools/" + name, f"#!{shutil.which('bash')}\n{script}\n"), 0o755)

    def run_script(self, name, *arguments):
        done = subprocess.run([os.path.join(self.tools, "bash"), os.path.join(self.folder, "scripts", name), *arguments],
                              capture_output=True, text=True, stdin=subprocess.DEVNULL, env={"PATH": self.tools})
        return done.returncode, done.stdout, done.stderr

    def test_missing_packages_are_listed_and_not_installed(self):
        self.assertEqual(self.run_script("setup", "--missing", "build"), (0, "cmake\n", ""))
        self.assertEqual(self.run_script("setup", "--missing"), (0, "cmake\nxvfb\n", ""))
        self.tool("dpkg-query", "echo 'ii g++'; echo 'ii  cmake'; echo 'rc xvfb'")
        self.assertEqual(self.run_script("setup", "--missing", "build"), (0, "", ""))
        self.assertEqual(self.run_script("setup", "--missing", "test"), (0, "xvfb\n", ""))
        code, _, errors = self.run_script("setup", "--unknown")
        self.assertEqual((code, "unknown argument --unknown" in errors), (2, True))

    def test_a_bare_machine_is_told_to_run_setup(self):
        code, output, errors = self.run_script("build", "paver_python")
        self.assertEqual((code, output), (1, ""))
        self.assertEqual(errors, "build: cmake or a C++ compiler is missing; run scripts/setup build, which installs what "
                                 "the build needs.\n")
        self.assertFalse(os.path.exists(os.path.join(self.folder, "build")))

    def test_missing_libraries_are_named_after_the_message_of_cmake(self):
        self.tool("c++", "exit 0")
        self.tool("cmake", "echo 'Could not find OpenCASCADE' >&2; exit 1")
        code, _, errors = self.run_script("build")
        self.assertEqual(code, 1)
        self.assertEqual(errors.splitlines(), ["Could not find OpenCASCADE", "build: packages are missing: cmake; run "
                                               "scripts/setup build, which installs them."])

    def test_a_build_of_another_place_is_configured_afresh(self):
        self.tool("c++", "exit 0")
        self.tool("cmake", f"[ ! -e {self.folder}/build/CMakeCache.txt ] || echo again; exit 0")
        cache = self.write("build/CMakeCache.txt", "CMAKE_HOME_DIRECTORY:INTERNAL=/nowhere/Paver\n")
        kept = self.write("build/core/kept.o", "")
        code, _, errors = self.run_script("build")
        self.assertEqual((code, errors), (0, f"build: {self.folder}/build was configured for /nowhere/Paver; configuring "
                                             "it afresh.\n"))
        self.assertTrue(os.path.exists(kept) and not os.path.exists(cache))
        self.write("build/CMakeCache.txt", f"CMAKE_HOME_DIRECTORY:INTERNAL={self.folder}\n")
        self.assertEqual(self.run_script("build")[2], "")
        self.assertTrue(os.path.exists(cache))

    def test_a_folder_that_cannot_be_written_is_named(self):
        self.tool("c++", "exit 0")
        self.tool("cmake", "exit 0")
        self.write("build", "a file")
        code, _, errors = self.run_script("build")
        self.assertEqual((code, errors), (1, f"build: {self.folder}/build cannot be written; check who owns it.\n"))


if __name__ == "__main__":
    unittest.main()
