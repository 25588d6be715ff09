"""The command line's contract with scripts: exit codes, one sentence on stderr, whole files or none, Ctrl-C.

Complements tests/property/command_line_test.py, which looks at what meshing itself must accept and refuse.
"""
import json
import os
import pty
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../support"))
import runs  # noqa: E402

BOX = os.path.join(runs.EXAMPLES, "box.step")
OK, OTHER, USAGE, INPUT, TOO_MANY, OUTPUT, CANCELLED = 0, 1, 2, 3, 5, 6, 130


def catches(pid, number):
    """Whether a process has come so far that it handles a signal: on a busy machine that may take seconds."""
    with open(f"/proc/{pid}/status") as file:
        caught = next(line.split()[1] for line in file if line.startswith("SigCgt:"))
    return int(caught, 16) >> (number - 1) & 1


class Contract(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = scratch.name
        self.out = os.path.join(self.folder, "out.msh")
        self.report = os.path.join(self.folder, "report.json")

    def call(self, *arguments, **more):
        return subprocess.run([runs.PROGRAM, *map(str, arguments)], stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, timeout=60, **more)

    def mesh(self, *arguments, **more):
        return self.call("mesh", BOX, "-o", self.out, *arguments, **more)

    def refused(self, done, code, says):
        self.assertEqual(done.returncode, code, done.stderr)
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), 1, done.stderr)
        self.assertTrue(lines[0].startswith("paver: ") and lines[0].endswith("."), done.stderr)
        self.assertIn(says, lines[0])
        self.assertEqual(os.listdir(self.folder), [])

    def test_bad_usage_is_2(self):
        self.refused(self.call(), USAGE, "paver mesh --help")
        self.refused(self.call("mash"), USAGE, "mash")
        self.refused(self.call("mesh", BOX), USAGE, "--output")
        self.refused(self.mesh("--size", "5", "--nonsense"), USAGE, "--nonsense")
        self.refused(self.mesh("--size", "5", "extra"), USAGE, "extra")
        self.refused(self.mesh("--size", "five"), USAGE, "five")
        self.refused(self.mesh("--size", "-1"), USAGE, "-1")
        self.refused(self.mesh("--size", "nan"), USAGE, "nan")
        self.refused(self.mesh("--size", "5", "--frequency", "1GHz"), USAGE, "--frequency")
        self.refused(self.mesh("--size", "5", "--divisions", "9"), USAGE, "--frequency")
        self.refused(self.mesh("--frequency", "1GHz", "--eps-r", "0"), USAGE, "--eps-r")
        self.refused(self.mesh("--size", "5", "--max-turn", "200"), USAGE, "--max-turn is 200 degrees")
        for option in ("--size", "--frequency"):
            for value in ("1e-300", "1e300"):
                self.refused(self.mesh(option, value), USAGE, " mm; it must be ")
        self.refused(self.mesh("--size", "5", "--report", ""), USAGE, "--report: the name of the file is empty")
        self.refused(self.mesh("--size", "5", "--msh-version", "3"), USAGE, "3")
        self.refused(self.mesh("--size", "5", "--order", "two"), USAGE, "two")
        self.refused(self.call("mesh", BOX, "-o", os.path.join(self.folder, "out.stl"), "--size", 5), USAGE, ".msh")

    def test_help_lists_every_option_of_the_readme(self):
        with open(os.path.join(runs.ROOT, "README.md")) as f:
            options = set(re.findall(r"^\| .*", f.read(), re.M))
        options = {name for line in options for name in re.findall(r"`(-[-\w]+)", line.split(" | ")[0])}
        self.assertGreater(len(options), 15)
        mesh, whole = self.call("mesh", "--help"), self.call("--help")
        self.assertEqual((mesh.returncode, mesh.stderr, whole.returncode, whole.stderr), (OK, "", OK, ""))
        listed = set(re.findall(r"^ +(-.*?)(?=  |$| [A-Z])", mesh.stdout, re.M))
        self.assertEqual(options - {name for line in listed for name in re.split(r"[, =]", line)}, set())
        self.assertIn("paver mesh --help", whole.stdout)
        for text in (mesh.stdout, whole.stdout):
            self.assertIn("Exit codes:", text)

    def test_bad_input_is_3_and_too_many_elements_5(self):
        self.refused(self.call("mesh", "nowhere.step", "-o", self.out, "--size", 5), INPUT, "nowhere.step")
        self.refused(self.mesh("--size", 1, "--max-elements", 10), TOO_MANY, "10")

    def test_the_library_for_a_format_lies_beside_the_program(self):
        with tempfile.TemporaryDirectory() as elsewhere:
            lone = [shutil.copy(runs.PROGRAM, elsewhere), "mesh", BOX, "-o", self.out, "--size", "20"]
            done = subprocess.run(lone, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60)
            self.refused(done, OTHER, "without the library libpaver_step.so")
            shutil.copy(os.path.join(os.path.dirname(runs.PROGRAM), "libpaver_step.so"), elsewhere)
            subprocess.run(lone, stdin=subprocess.DEVNULL, capture_output=True, timeout=60, check=True)

    def test_unwritable_output_is_6_before_any_meshing(self):
        self.refused(self.call("mesh", BOX, "-o", "/no/such/out.msh", "--size", 5), OUTPUT, "/no/such/out.msh")
        self.refused(self.mesh("--size", 5, "--report", "/no/such/report.json"), OUTPUT, "/no/such/report.json")
        self.refused(self.mesh("--size", 5, "--report", "/dev/null"), OUTPUT, "/dev/null")

    def test_the_input_is_never_written_over(self):
        copy = os.path.join(self.folder, "box.step")
        with open(BOX, "rb") as source, open(copy, "wb") as target:
            target.write(source.read())
        done = self.call("mesh", copy, "-o", self.out, "--size", 20, "--report", copy)
        self.assertEqual((done.returncode, os.listdir(self.folder)), (USAGE, ["box.step"]), done.stderr)

    def test_a_full_disk_is_6_and_leaves_nothing(self):
        limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (2000, resource.RLIM_INFINITY))  # noqa: E731
        self.refused(self.mesh("--size", 5, "--report", self.report, preexec_fn=limit), OUTPUT, "out.msh")

    def test_success_is_silent_on_stderr_and_quiet_everywhere(self):
        done = self.mesh("--size", "20 mm", "--report", self.report)
        self.assertEqual((done.returncode, done.stderr), (OK, ""))
        self.assertIn("paving", done.stdout)
        self.assertIn("SJ", done.stdout)
        with open(self.report) as f:
            report = json.load(f)
        self.assertEqual(report["target_length"], 20)
        self.assertEqual(sorted(os.listdir(self.folder)), ["out.msh", "report.json"])
        done = self.mesh("--size", "2cm", "--quiet")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (OK, "", ""))

    def test_files_are_whole_where_standard_streams_are_closed(self):
        command = [runs.PROGRAM, "mesh", BOX, "-o", self.out, "--size", "5", "--ascii", "--report", self.report]
        subprocess.run(["sh", "-c", 'exec "$@" <&- >&- 2>&-', "sh", *command], timeout=60, check=True)
        with open(self.out) as mesh, open(self.report) as report:
            self.assertTrue(mesh.read().startswith("$MeshFormat"))
            self.assertEqual(json.load(report)["target_length"], 5)

    def test_versions_and_ascii(self):
        for options, head in ((["--msh-version", "2.2"], "2.2 1 8"), (["--msh-version", "2.2", "--ascii"], "2.2 0 8"),
                              (["--ascii"], "4.1 0 8"), ([], "4.1 1 8")):
            with self.subTest(options=options):
                self.assertEqual(self.mesh("--size", 20, *options).returncode, OK)
                with open(self.out, "rb") as f:
                    self.assertEqual(f.read(40).decode(errors="replace").splitlines()[1], head)
                mesh = runs.meshfile.read(self.out)
                self.assertEqual(sorted(set(mesh.quad_tag)), [1, 2, 3, 4, 5, 6])
                self.assertEqual(len([k for k in mesh.names if k[0] == 2]), 6)

    def test_progress_is_one_line_on_a_terminal(self):
        master, slave = pty.openpty()
        done = subprocess.run([runs.PROGRAM, "mesh", BOX, "-o", self.out, "--size", "2"], stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=slave, text=True, timeout=60)
        os.close(slave)
        shown = os.read(master, 1 << 16).decode()
        os.close(master)
        self.assertEqual(done.returncode, OK)
        self.assertIn("%", shown)
        self.assertNotIn("\n", shown)
        self.assertTrue(shown.endswith("\r\x1b[K"), "the line is cleared at the end")
        self.assertNotIn("100 %", done.stdout)

    def test_signals_end_it_within_a_second_with_130_and_no_file(self):
        wing = os.path.join(runs.EXAMPLES, "wing.step")
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(number=number):
                process = subprocess.Popen([runs.PROGRAM, "mesh", wing, "-o", self.out, "--size", "0.2", "--report",
                                            self.report, "--max-elements", "50000000"], stdin=subprocess.DEVNULL,
                                           stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
                while process.poll() is None and not catches(process.pid, number):
                    time.sleep(0.05)
                time.sleep(0.5)
                self.assertIsNone(process.poll(), "ended before it was stopped")
                start = time.time()
                process.send_signal(number)
                _, error = process.communicate(timeout=60)
                self.assertLess(time.time() - start, 5 if "sanitize" in runs.PROGRAM else 1)
                self.assertEqual(process.returncode, CANCELLED, error)
                self.assertEqual(len(error.splitlines()), 1, error)
                self.assertEqual(os.listdir(self.folder), [])


if __name__ == "__main__":
    unittest.main()
