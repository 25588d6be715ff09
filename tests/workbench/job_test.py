"""Workbench/mesh.FCMacro: documents and CAD files, exports, the report, exit codes."""
import csv
import json
import os
import re
import shlex
import shutil
import subprocess

import pytest

import freecad_program
from repo import ROOT, text

MACRO = os.path.join(ROOT, "Workbench", "mesh.FCMacro")
EXAMPLES = os.path.join(ROOT, "Resources", "examples")

# A document with a box (labelled "Case"), a ball, a mesh object of the box, and a compound of which one face is endless.
DOCUMENT = """
import sys
import FreeCAD, Part
from paver_wb import mesh_object
document = FreeCAD.newDocument("made")
box = document.addObject("Part::Box", "Box")
box.Label = "Case"
document.addObject("Part::Sphere", "Ball")
document.addObject("Part::Feature", "Bad").Shape = Part.makeCompound([Part.makePlane(5, 5), Part.Plane().toShape()])
document.recompute()
mesh_object.add(document, box, size=4)
document.saveAs(sys.argv[-1])
sys.exit(0)
"""


@pytest.fixture
def job(home, tmp_path):
    """Runs the macro in a folder of its own; gives (exit code, entries of the report, errors)."""
    def run(*arguments):
        report = tmp_path / "report.json"
        report.unlink(missing_ok=True)
        done = freecad_program.run([MACRO, "--", *map(str, arguments), "--report", str(report)], home)
        content = json.loads(report.read_text()) if report.exists() else None
        if content:
            assert content["exit_code"] == done.returncode
        return done.returncode, content and content["runs"], done.stderr
    return run


@pytest.fixture
def document(home, tmp_path):
    macro, path = tmp_path / "make.FCMacro", tmp_path / "made.FCStd"
    macro.write_text(DOCUMENT)
    done = freecad_program.run([str(macro), "--", str(path)], home)
    assert done.returncode == 0, done.stdout + done.stderr
    return str(path)


@pytest.fixture
def models(tmp_path):
    return [shutil.copy(os.path.join(EXAMPLES, name), tmp_path) for name in ("box.step", "conesphere.step")]


def test_cad_files_to_every_format(job, models, tmp_path):
    out = tmp_path / "out"
    out.mkdir()
    code, runs, errors = job(*models, "--size", "12 mm", "--export", "msh,vtu,unv,inp,med", "--folder", out, "--save")
    assert (code, [r["status"] for r in runs], errors.strip()) == (0, ["meshed"] * 2, "")
    stems = ["box", "conesphere"]
    wanted = {f"{stem}{end}" for stem in stems for end in (".msh", ".vtu", ".unv", ".inp", ".med", "-mesh.FCStd")}
    assert set(os.listdir(out)) == wanted
    assert {os.path.basename(f) for r in runs for f in r["files"]} == wanted
    for stem, run in zip(stems, runs):
        quality = run["report"]["quality"]
        inp = (out / f"{stem}.inp").read_text()
        assert inp.upper().count("TYPE=S8") == 1
        blocks = re.split(r"\n\*", inp)
        rows = [len(b.splitlines()) - 1 for b in blocks if re.match(r"ELEMENT.*TYPE=S", b, re.I)]
        assert sum(rows) == quality["quads"] + quality["triangles"]
        assert (out / f"{stem}.msh").read_bytes()[:11] == b"$MeshFormat"


def test_mesh_objects_of_a_document(job, document):
    code, runs, _ = job(document, "--save")
    assert (code, [r["object"] for r in runs]) == (0, ["PaverMesh"])
    quads = runs[0]["report"]["quality"]["quads"]
    assert runs[0]["report"]["target_length"] == 4 and runs[0]["files"] == [document]
    code, runs, _ = job(document, "--frequency", "30 GHz", "--order", "1", "--export", "msh")
    assert code == 0 and runs[0]["report"]["order"] == 1
    assert abs(runs[0]["report"]["target_length"] - 0.99930819) < 1e-6
    assert runs[0]["report"]["quality"]["quads"] > quads
    assert os.path.basename(runs[0]["files"][0]) == "made-PaverMesh.msh"
    code, runs, _ = job(document)  # the last run did not save
    assert runs[0]["report"]["quality"]["quads"] == quads


def test_named_objects(job, document):
    code, runs, _ = job(document, "--objects", "Ball,Case,PaverMesh", "--size", "3")
    assert (code, [r["object"] for r in runs]) == (0, ["BallMesh", "BoxMesh", "PaverMesh"])
    assert runs[1]["report"]["checksum"] == runs[2]["report"]["checksum"]
    code, runs, errors = job(document, "--objects", "Ball,Nothing", "--size", "3")
    assert code == 2 and "has no object 'Nothing'" in errors and "PaverMesh" in errors


def test_a_face_that_fails_is_reported_and_the_others_are_written(job, document):
    code, runs, errors = job(document, "--objects", "Bad,Ball", "--size", "3", "--export", "msh")
    assert code == 4 and [r["status"] for r in runs] == ["faces_failed", "meshed"]
    assert "Face2" in errors and all(os.path.getsize(r["files"][0]) > 0 for r in runs)


def test_bad_models_do_not_keep_the_next_back(job, models, tmp_path):
    damaged = tmp_path / "damaged.FCStd"
    damaged.write_bytes(b"no document")
    code, runs, errors = job(tmp_path / "none.step", damaged, models[0], "--size", "20")
    assert (code, [r["exit_code"] for r in runs]) == (3, [3, 3, 0])
    assert "does not exist" in errors and "damaged.FCStd cannot be read" in errors


def test_a_series_of_frequencies_gives_files_a_table_and_entries(job, models, tmp_path):
    out = tmp_path / "out"
    out.mkdir()
    code, runs, errors = job(*models, "--frequencies", "3GHz,900THz,6 GHz", "--export", "msh", "--folder", out)
    assert (code, [r["exit_code"] for r in runs]) == (5, [0, 0, 5] * 2)
    assert [r["step"] for r in runs[:3]] == [{"frequency": f} for f in (3e9, 6e9, 9e14)]
    assert "box.step, ShapeMesh, 900 THz: About" in errors
    assert set(os.listdir(out)) == {f"{stem}-{end}" for stem in ("box", "conesphere")
                                    for end in ("3GHz.msh", "6GHz.msh", "series.csv")}
    with open(out / "box-series.csv", newline="") as file:
        table = list(csv.DictReader(file))
    assert [float(row["frequency_Hz"]) for row in table] == [3e9, 6e9, 9e14]
    for row, run in zip(table[:2], runs):
        assert int(row["unknowns"]) == run["table"]["unknowns"] == 2 * run["report"]["quality"]["quads"]  # closed, all quads
        assert int(row["matrix_bytes"]) == 16 * int(row["unknowns"]) ** 2 and row["verdict"] == "good"
    assert (table[2]["elements"], table[2]["error"]) == ("", runs[2]["table"]["error"]) and "predicted" in table[2]["error"]


def test_a_series_of_divisions_is_saved_in_the_document(job, document):
    code, runs, errors = job(document, "--frequency", "30 GHz", "--series", "divisions=4,6", "--save")
    assert (code, len(runs)) == (0, 2), errors
    code, runs, _ = job(document, "--objects", "PaverMesh_1,PaverMesh_2")
    lengths = [run["report"]["target_length"] for run in runs]
    assert code == 0 and abs(lengths[0] / lengths[1] - 1.5) < 1e-9
    code, runs, _ = job(document)  # the steps of a series are no mesh objects to mesh unasked
    assert [run["object"] for run in runs] == ["PaverMesh"]
    code, runs, _ = job(document, "--size", "4", "--series", "divisions=4,6")
    assert (code, len(runs)) == (2, 1) and "no frequency" in runs[0]["error"]


@pytest.mark.parametrize("arguments, code, text_", [
    (["--size", "3", "--order", "7"], 2, "order is 7"), (["--size", "x"], 2, "size is"), ([], 2, "size"),
    (["--size", "3", "--divisions", "none"], 2, "--divisions needs --frequency"),
    (["--size", "3", "--max-elements", "4"], 5, "raise --max-elements"), (["--export", "stl"], 2, "--export has 'stl'"),
    (["--series", "order=1,2"], 2, "not 'order'"), (["--frequencies", "3 mm"], 2, "'3 mm' of a series cannot be read"),
    (["--size", "9", "--folder", "nowhere"], 6, "does not exist"), (["--no-such"], 2, "was not expected")])
def test_what_is_refused(job, models, arguments, code, text_):
    got, _, errors = job(models[0], *arguments)
    assert got == code and text_ in errors and "Traceback" not in errors, errors


FAULTS = [
    "none.step --size 2", "empty.step --size 2", "text.step --size 2", "cut.step --size 2", "note.txt --size 2", ". --size 2",
    "none.brep --size 2", "bad.brep --size 2", "box.step", "box.step --size x", "box.step --size -1", "box.step --size 2 --order 9",
    "box.step --size 2 --divisions none", "box.step --size 1 --max-elements 10", "box.step --size 2 --no-such",
    "box.step --size 2 --frequency 3GHz", "box.step --size 20 --report nowhere/r.json", "box.step --size 20 --local Face99=1",
    "box.step --size 20 --local Face1=9 --local Face99=1", "box.step --size 20 --local Face1=x",
    "box.step --size 20 --elements hexa", "box.step --size 2mm --gradation nan", "none.step --size x"]
SHAPES = """
import sys, FreeCAD, Part
Part.makeCompound([Part.makePlane(5, 5), Part.Plane().toShape()]).exportBrep("bad.brep")
Part.makeCompound([]).exportBrep("none.brep")
sys.exit(0)
"""


def test_faults_have_the_codes_and_sentences_of_the_command_line(home, models, tmp_path):
    content = (tmp_path / "box.step").read_bytes()
    for name, what in (("empty.step", b""), ("text.step", b"hello"), ("cut.step", content[:len(content) // 2]),
                       ("note.txt", b"x"), ("shapes.FCMacro", SHAPES.encode())):
        (tmp_path / name).write_bytes(what)
    environment = {**os.environ, "FREECAD_USER_HOME": home}

    def told(*command):
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, stdin=subprocess.DEVNULL, env=environment,
                              timeout=120)
        return done.returncode, done.stderr.strip().splitlines()[-1:]
    assert told(freecad_program.program(), "shapes.FCMacro")[0] == 0
    for fault in FAULTS:
        words = shlex.split(fault)
        code, (sentence,) = told(os.path.join(os.environ["PAVER_BUILD"], "core", "paver"), "mesh", *words, "-o", "o.msh")
        got, (text_,) = told(freecad_program.program(), MACRO, "--", *words)
        assert (got, text_[-len(sentence) + len("paver: "):]) == (code, sentence[len("paver: "):]), (fault, text_)


def test_nothing_but_what_is_asked_for_is_printed(home, models):
    done = freecad_program.run([MACRO, "--", models[0], "--size", "20"], home)
    assert done.returncode == 0 and "Group" not in done.stdout and "Face1" not in done.stdout, done.stdout


def test_models_of_one_name_are_refused_before_any_work(job, models, tmp_path):
    (tmp_path / "sub").mkdir()
    same = shutil.copy(models[0], tmp_path / "sub")
    code, runs, errors = job(models[0], same, "--size", "9", "--export", "msh", "--folder", tmp_path)
    assert (code, runs) == (2, None) and "same names" in errors


def test_without_the_core(home, models, tmp_path):
    done = freecad_program.run([MACRO, "--", models[0]], home, PAVER_BUILD=str(tmp_path))
    assert done.returncode == 1 and "run scripts/build paver_python" in done.stderr


def test_without_a_linked_add_on(home, models):
    os.remove(os.path.join(home, "Mod", "Paver"))
    done = freecad_program.run([MACRO, "--", models[0], "--size", "20"], home)
    assert done.returncode == 0 and "quads" in done.stdout, done.stderr


def test_the_examples_of_the_page_run(home, document, tmp_path):
    """Word for word, with files of those names."""
    for name in ("antenna.FCStd", "satellite.FCStd"):
        shutil.copy(document, tmp_path / name)
    for name in ("wing.step", "torus.step"):
        shutil.copy(os.path.join(EXAMPLES, name), tmp_path)
    (tmp_path / "out").mkdir()
    lines = [line.strip() for line in text("Workbench/README.md").splitlines()
             if line.startswith("    freecadcmd Workbench/mesh.FCMacro")]
    assert len(lines) == 5
    for line in lines:
        words = shlex.split(line.replace("Body,Reflector", "Box,Ball"))
        words = [str(tmp_path / w) if w.endswith((".FCStd", ".step", ".json")) or w == "out" else w for w in words]
        done = freecad_program.run([MACRO, *words[2:]], home)
        assert done.returncode == 0, line + done.stdout + done.stderr
    assert {"wing.msh", "torus.inp", "report.json"} <= set(os.listdir(tmp_path / "out"))
    assert (tmp_path / "satellite-BallMesh.vtu").exists()
    assert {f"antenna-PaverMesh-{end}" for end in ("1GHz.msh", "4GHz.msh", "series.csv")} <= set(os.listdir(tmp_path))
