"""The command line as a contract: what works, what bad input gives, and that no half file is ever left."""
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import runs  # noqa: E402

BOX = os.path.join(runs.EXAMPLES, "box.step")
EMPTY_STEP = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));
ENDSEC;
DATA;
ENDSEC;
END-ISO-10303-21;
"""


def call(*arguments, limit=60):
    done = subprocess.run([runs.PROGRAM, *map(str, arguments)], stdin=subprocess.DEVNULL, capture_output=True,
                          text=True, timeout=limit)
    return done.returncode, done.stdout, done.stderr


class CommandLine(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = self.scratch.name
        self.out = os.path.join(self.folder, "out.msh")

    def path(self, name, content):
        path = os.path.join(self.folder, name)
        with open(path, "w") as f:
            f.write(content)
        return path

    def refused(self, *arguments, says=""):
        """Non-zero exit code, one clear line, nothing written."""
        before = sorted(os.listdir(self.folder))
        code, _, error = call(*arguments)
        self.assertNotEqual(code, 0, arguments)
        self.assertGreater(code, 0, f"ended by a signal: {error}")
        lines = [line for line in error.splitlines() if line.strip()]
        self.assertEqual(len(lines), 1, error)
        self.assertRegex(lines[0], r"(?i)" + says)
        self.assertNotRegex(error, r"Standard_|StdFail|terminate called|std::|\bnan\b.*\bnan\b")
        self.assertEqual(sorted(os.listdir(self.folder)), before)

    def test_help_and_version(self):
        code, text, _ = call("--help")
        self.assertEqual(code, 0)
        self.assertIn("mesh", text)
        code, text, _ = call("mesh", "--help")
        self.assertEqual(code, 0)
        for option in ("--size", "--frequency", "--divisions", "--order", "--threads", "--report", "--max-turn",
                       "--max-elements", "--elements", "--sew-tolerance", "--eps-r", "--mu-r"):
            self.assertIn(option, text)
        code, text, _ = call("--version")
        self.assertEqual(code, 0)
        self.assertRegex(text, r"\d+\.\d+\.\d+")

    def test_bad_files(self):
        files = {os.path.join(self.folder, "missing.step"): "missing.step", self.folder: "",
                 self.path("empty.step", ""): "empty", self.path("text.step", "hello, world\n" * 50): "",
                 self.path("nothing.step", EMPTY_STEP): "face",
                 self.path("half.brep", "\nCASCADE Topology V3, (c) Open Cascade\nLocations 3\n1\n"): ""}
        for file, says in files.items():
            with self.subTest(file=os.path.basename(file)):
                self.refused("mesh", file, "-o", self.out, "--size", 5, says=says)

    def test_files_cut_off_anywhere(self):
        for name in ("wing.step", "conesphere_one_face.brep"):
            with open(os.path.join(runs.EXAMPLES, name)) as f:
                whole = f.read()
            for share in (0.02, 0.3, 0.9, 0.999):
                with self.subTest(name=name, share=share):
                    cut = self.path("cut" + name[name.index("."):], whole[:int(share * len(whole))])
                    self.refused("mesh", cut, "-o", self.out, "--size", 5, says="cut off")

    def test_bytes_that_are_no_text(self):
        for name in ("noise.step", "noise.igs", "noise.brep"):
            path = os.path.join(self.folder, name)
            with open(path, "wb") as f:
                f.write(bytes(range(256)) * 100)
            self.refused("mesh", path, "-o", self.out, "--size", 5, says="STEP, IGES or BREP")

    def test_bad_options(self):
        for options in (["--size", "0"], ["--size", "-1"], ["--size", "nan"], ["--size", "inf"], ["--size", "five"], [],
                        ["--size", "5", "--frequency", "3GHz"], ["--frequency", "0"], ["--frequency", "3parsec"],
                        ["--size", "5", "--elements", "all-pentagon"], ["--size", "5", "--order", "7"], ["--size", "5", "--threads", "-2"],
                        ["--frequency", "1GHz", "--divisions", "0"], ["--size", "5", "--nonsense"],
                        ["--size", "5", "--max-turn", "0"], ["--frequency", "1GHz", "--eps-r", "-1"],
                        ["--size", "5", "--sew-tolerance", "-1"]):
            with self.subTest(options=options):
                self.refused("mesh", BOX, "-o", self.out, *options)

    def test_an_absurd_size_is_refused_with_the_predicted_count(self):
        for size in ("1e-6", "1e-9", "1e-300"):
            self.refused("mesh", BOX, "-o", self.out, "--size", size, says=r"\d{3,}|\de\+?\d")
        self.refused("mesh", BOX, "-o", self.out, "--size", 1, "--max-elements", 100, says=r"--max-elements|100")

    def test_unwritable_output(self):
        missing = os.path.join(self.folder, "missing", "out.msh")
        self.refused("mesh", BOX, "-o", missing, "--size", 10, says="missing")
        self.refused("mesh", BOX, "-o", os.path.join(self.folder, "out.xyz"), "--size", 10, says="msh")
        self.refused("mesh", BOX, "-o", self.folder, "--size", 10)

    def test_frequency_gives_the_target_length(self):
        run = runs.paver(BOX, self.out, "--frequency", "3GHz", "--divisions", 5, "--eps-r", 4)
        self.assertEqual(run.code, 0, run.output)
        self.assertAlmostEqual(run.report["target_length"], 299792458e3 / 3e9 / 5 / 2, places=6)

    def test_a_box_at_low_frequency_is_six_quads(self):
        run = runs.paver(BOX, self.out, "--size", 1000)
        self.assertEqual((run.code, len(run.mesh.quads), len(run.mesh.triangles)), (0, 6, 0), run.output)

    def test_kinds_of_elements(self):
        plate = os.path.join(runs.EXAMPLES, "plate_nine_holes.step")
        counts = {}
        for kind in ("quad-dominant", "all-quad", "all-triangle"):
            with self.subTest(kind=kind):
                run = runs.paver(plate, self.out, "--size", 8, "--elements", kind)
                self.assertEqual(run.code, 0, run.output)
                self.assertEqual(run.report["elements"], kind)
                self.assertEqual(run.report["quality"]["inverted"], 0)
                self.assertEqual([note for note in run.report["notes"] if note.startswith("Triangles remain")], [])
                counts[kind] = len(run.mesh.quads), len(run.mesh.triangles)
        self.assertEqual(counts["all-quad"][1], 0)
        self.assertEqual(counts["all-triangle"][0], 0)
        quads, triangles = counts["quad-dominant"]
        self.assertEqual(counts["all-triangle"][1], 2 * quads + triangles)

    def test_triangles_among_quads_only_are_named(self):
        wing = os.path.join(runs.EXAMPLES, "wing.step")
        for size in (60, 25):
            run = runs.paver(wing, self.out, "--size", size, "--elements", "all-quad")
            self.assertEqual(run.code, 0, run.output)
            named = [note for note in run.report["notes"] if note.startswith("Triangles remain")]
            self.assertEqual(bool(named), bool(len(run.mesh.triangles)), named)

    def test_an_old_file_is_replaced_only_by_a_whole_one(self):
        self.path("out.msh", "old")
        self.refused("mesh", BOX, "-o", self.out, "--size", "-1")
        with open(self.out) as f:
            self.assertEqual(f.read(), "old")
        self.assertEqual(call("mesh", BOX, "-o", self.out, "--size", 20)[0], 0)
        self.assertEqual(len(runs.meshfile.read(self.out).quads) > 6, True)

    def test_interrupt_stops_within_a_second_and_leaves_nothing(self):
        for wait in (0.3, 1.5, 3.0):
            with self.subTest(wait=wait):
                wing = os.path.join(runs.EXAMPLES, "wing.step")
                process = subprocess.Popen([runs.PROGRAM, "mesh", wing, "-o", self.out, "--size", "0.2",
                                            "--max-elements", "20000000"], stdin=subprocess.DEVNULL,
                                           stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
                time.sleep(wait)
                self.assertIsNone(process.poll(), "ended before it was interrupted")
                start = time.time()
                process.send_signal(signal.SIGINT)
                _, error = process.communicate(timeout=60)
                slow = 5 if "sanitize" in runs.PROGRAM else 1
                self.assertLess(time.time() - start, slow)
                self.assertNotEqual(process.returncode, 0)
                self.assertNotIn("terminate", error)
                self.assertEqual(os.listdir(self.folder), [])

    def loose_box(self):
        """The box of the examples as six faces that share nothing."""
        return os.path.join(runs.ROOT, "tests", "property", "loose_box.brep")

    def test_strict_refuses_what_would_be_repaired(self):
        self.refused("mesh", self.loose_box(), "-o", self.out, "--size", 20, "--strict", says="not clean.*24 sewn edges.*;")
        code, _, error = call("mesh", BOX, "-o", self.out, "--size", 20, "--strict")
        self.assertEqual((code, error), (0, ""))

    def test_a_repaired_model_is_clean(self):
        repaired, report = os.path.join(self.folder, "whole.brep"), os.path.join(self.folder, "report.json")
        code, _, error = call("mesh", self.loose_box(), "-o", self.out, "--size", 20, "--repaired", repaired, "--report", report)
        self.assertEqual((code, error), (0, ""))
        with open(report) as f:
            first = json.load(f)
        self.assertIn("sewn edges", [repair["kind"] for repair in first["model"]["repairs"]])
        code, _, error = call("mesh", repaired, "-o", self.out, "--size", 20, "--strict", "--report", report)
        self.assertEqual((code, error), (0, ""))
        with open(report) as f:
            again = json.load(f)
        self.assertEqual((again["model"]["solids"], again["model"]["faces"], again["model"]["repairs"]), (1, 6, []))
        self.assertEqual(again["quality"]["quads"], first["quality"]["quads"])

    def test_a_bad_name_for_the_repaired_model_is_refused(self):
        self.refused("mesh", BOX, "-o", self.out, "--size", 20, "--repaired", os.path.join(self.folder, "a.step"), says=r"end in \.brep")
        self.refused("mesh", BOX, "-o", self.out, "--size", 20, "--repaired", os.path.join(self.folder, "no", "a.brep"), says="a.brep")

    def test_output_formats(self):
        for name in ("out.msh", "out.vtu"):
            with self.subTest(name=name):
                out = os.path.join(self.folder, name)
                report = os.path.join(self.folder, "report.json")
                code, _, error = call("mesh", BOX, "-o", out, "--size", 20, "--report", report)
                self.assertEqual(code, 0, error)
                self.assertGreater(os.path.getsize(out), 1000)
                with open(report) as f:
                    self.assertEqual(len(json.load(f)["faces"]), 6)


if __name__ == "__main__":
    unittest.main()
