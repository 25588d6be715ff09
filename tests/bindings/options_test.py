"""Every option of the command line is an argument, and means the same."""
import inspect
import os
import re
import subprocess

import pytest

import paver

# A value of each option, as text and as Python may say it, the options it needs, and whether it changes the mesh.
VALUES = {
    "size": ("9 mm", 9, {}, True),
    "frequency": ("4 GHz", 4e9, {"size": None}, True),
    "divisions": ("7", 7, {"size": None, "frequency": "4GHz"}, True),
    "eps_r": ("1.5", 1.5, {"size": None, "frequency": "4GHz"}, True),
    "mu_r": ("0.75", 0.75, {"size": None, "frequency": "4GHz"}, True),
    "max_turn": ("20 deg", 20, {}, True),
    "aspect": ("1", 1, {}, True),
    "gradation": ("0.2", 0.2, {"max_turn": "15"}, True),
    "tip": ("2", 2, {}, False),
    "grade_edges": ("2", 2, {}, True),
    "gap": ("refine:3", "refine:3", {}, True),
    "merge": ("off", 0, {}, False),
    "merge_width": ("0.01", 0.01, {}, False),
    "chord_error": ("1 mm", 1, {}, False),
    "local": ("Face1=3;Edge2=eps-r:9", {"Face1": 3, "Edge2": {"eps_r": 9}}, {"size": None, "frequency": "2.5GHz"}, True),
    "medium": ("M=Solid1,eps-r:4", {"M": {"parts": ["Solid1"], "eps_r": 4}}, {"size": None, "frequency": "2.5GHz"}, True),
    "port": ("P=Edge1,Face2", {"P": ["Edge1", "Face2"]}, {}, False),
    "wire": ("W=Edge1,radius:0.5mm", {"W": {"parts": "Edge1", "radius": 0.5}}, {}, False),
    "max_elements": ("100000", 100000, {}, False),
    "order": ("1", 1, {}, True),
    "elements": ("all-triangle", "all-triangle", {}, True),
    "multilevel": ("auto", "auto", {}, False),
    "threads": ("1", 1, {}, False),
    "ranks": ("0", 0, {}, False),
    "connect": ("union", "union", {}, False),
    "sew_tolerance": ("20 um", 0.02, {}, False),
    "strict": ("on", True, {}, False),
}
FILE_OPTIONS = {"output", "report", "repaired", "msh_version", "ascii", "quiet"}


def command_line_options(program):
    """Names in the command line's own help."""
    text = subprocess.run([program, "mesh", "--help"], capture_output=True, text=True, check=True).stdout
    names = re.findall(r"^  (?:-\w,)?--([\w-]+)", text, re.M)
    return [name.replace("-", "_") for name in names if name != "help"]


def test_every_option_of_the_command_line_is_an_argument(program):
    names = command_line_options(program)
    assert {"size", "output", "ascii", "max_turn"} <= set(names), "the help was read"
    arguments = inspect.signature(paver.mesh).parameters
    assert [name for name in names if name not in arguments] == []
    assert sorted(names) == sorted(FILE_OPTIONS | {info["name"] for info in paver.options()})
    for info in paver.options():
        assert info["name"] in inspect.signature(paver.predict).parameters
        assert f"    {info['name']} ({info['kind']}): {info['help']}" in paver.mesh.__doc__


def test_every_option_has_a_value_here():
    assert sorted(VALUES) == sorted(info["name"] for info in paver.options())


@pytest.fixture(scope="module")
def plain():
    """Checksums of meshes with no option but those given."""
    known = {}

    def checksum(model, options):
        key = tuple(sorted(options.items()))
        if key not in known:
            known[key] = paver.mesh(model, **options).report["checksum"]
        return known[key]
    return checksum


@pytest.mark.parametrize("name", VALUES)
def test_every_option_reaches_the_core_and_means_what_the_command_line_means(name, example, program, plain, tmp_path):
    model = example("wing.step")
    text, value, needs, changes = VALUES[name]
    base = {k: v for k, v in {"size": 12, **needs}.items() if v is not None}
    as_text, as_value = (paver.mesh(model, **{**base, name: v}) for v in (text, value))
    out = tmp_path / "mesh.msh"
    arguments = [a for k, v in {**base, name: text}.items() for a in ("--" + k.replace("_", "-"), *([] if k == "strict" else [str(v)]))]
    subprocess.run([program, "mesh", model, "-o", out, "--report", tmp_path / "r.json", "--quiet", *arguments],
                   check=True, stdin=subprocess.DEVNULL)
    as_text.write(tmp_path / "python.msh")
    assert (tmp_path / "python.msh").read_bytes() == out.read_bytes()
    assert as_value.report["checksum"] == as_text.report["checksum"]
    without = base if name != "frequency" else {"size": 12}
    assert (plain(model, without) != as_text.report["checksum"]) == changes
    with pytest.raises(paver.OptionError, match=f"^{name} is '\\?'; write it like "):
        paver.mesh(model, **{**base, name: "?"})


def test_limits_reach_the_core_too(box):
    with pytest.raises(paver.LimitError, match="above the limit of 50"):
        paver.mesh(box, size=2, max_elements=50)
    assert paver.predict(box, size=2, max_elements=50).elements > 50
    with pytest.raises(paver.OptionError, match="^sew_tolerance is -1 mm"):
        paver.mesh(box, size=5, sew_tolerance=-1)
    with pytest.raises(paver.OptionError, match="^threads is 5000"):
        paver.mesh(box, size=5, threads=5000)
    assert paver.mesh(box, size=20, threads=1).report["threads"] == 1


@pytest.mark.parametrize("options, says", [
    ({}, "No target length"), ({"size": "five"}, "size is 'five'"), ({"size": 0}, "size is 0 mm"),
    ({"size": float("nan")}, "size is nan"), ({"size": 5, "order": 1.5}, "order is '1.5'"),
    ({"size": 5, "frequency": 1e9}, "frequency excludes size"), ({"size": 5, "divisions": 3}, "needs frequency"),
    ({"size": True}, "size is True"), ({"size": [5]}, r"size is \[5\]"), ({"size": 5, "sise": 6}, "no option 'sise'"),
    ({"size": 5, "elements": "quads"}, "elements is 'quads'"), ({"size": "3 GHz"}, "size is '3 GHz'")])
def test_wrong_options_are_refused_before_any_work(box, options, says):
    for function in (paver.mesh, paver.predict):
        with pytest.raises(paver.OptionError, match=says) as refused:
            function(box, **options)
        assert refused.value.code == "bad_option" and isinstance(refused.value, ValueError)


def test_numbers_of_other_kinds_count_as_numbers(box):
    import decimal
    import fractions

    import numpy as np
    wanted = paver.mesh(box, size=12.5).report["checksum"]
    for size in (np.float64(12.5), np.float32(12.5), fractions.Fraction(25, 2), "12.5", "1.25 cm"):
        assert paver.mesh(box, size=size, order=np.int64(2)).report["checksum"] == wanted
    with pytest.raises(paver.OptionError):
        paver.mesh(box, size=decimal.Decimal("12.5"))
    third = paver.mesh(box, size=40 / 3)
    assert third.report["target_length"] == 40 / 3, "every bit of a number arrives"


def test_files_are_written_as_the_command_line_writes_them(box, program, tmp_path):
    for name, options, arguments in [
            ("a.msh", {}, []), ("b.msh", {"ascii": True}, ["--ascii"]), ("d.vtu", {}, []),
            ("c.msh", {"msh_version": "2.2"}, ["--msh-version", "2.2"]), ("e.vtu", {"ascii": True}, ["--ascii"])]:
        ours, other, late = (str(tmp_path / (kind + name)) for kind in ("python_", "program_", "late_"))
        result = paver.mesh(box, size=20, output=ours, report=tmp_path / "r.json", **options)
        subprocess.run([program, "mesh", box, "-o", other, "--size", "20", "--quiet", *arguments], check=True)
        result.write(tmp_path / ("late_" + name), **options)
        contents = {open(path, "rb").read() for path in (ours, other, late)}
        assert len(contents) == 1, name
    assert (tmp_path / "r.json").read_text().startswith("{")


def test_quiet_prints_nothing_and_loud_the_table(box, capsys):
    result = paver.mesh(box, size=20)
    assert capsys.readouterr().out == ""
    paver.mesh(box, size=20, quiet=False)
    out = capsys.readouterr().out
    assert out.startswith("read\n") and "done\n" in out
    assert out.split("done\n")[1].splitlines()[:5] == result.table.splitlines()[:5]


def test_predictions_come_near(example):
    model = paver.Model(example("box_cylinder.step"))
    prediction = paver.predict(model, frequency="9 GHz", divisions=8)
    result = paver.mesh(model, frequency="9 GHz", divisions=8)
    assert prediction.elements == pytest.approx(len(result.quads) + len(result.triangles), rel=0.2)
    assert prediction.target_length == result.report["target_length"]
    assert len(prediction.face_elements) == len(result.face_names)
    assert prediction.memory_mib > 0


def loose_box():
    return os.path.join(os.path.dirname(__file__), "..", "property", "loose_box.brep")


def test_strict_refuses_a_model_that_needs_repairs():
    with pytest.raises(paver.InputError, match="not clean.*24 sewn edges"):
        paver.mesh(loose_box(), size=20, strict=True)
    assert paver.mesh(loose_box(), size=20, strict=False).report["model"]["repairs"][0]["count"] == 24
    with pytest.raises(paver.OptionError, match="^strict is 'perhaps'"):
        paver.mesh(loose_box(), size=20, strict="perhaps")


def test_the_repaired_model_is_written(tmp_path):
    whole = tmp_path / "whole.brep"
    paver.mesh(loose_box(), size=20, repaired=whole)
    model = paver.mesh(whole, size=20, strict=True).report["model"]
    assert (model["solids"], model["faces"], model["repairs"]) == (1, 6, [])
    with pytest.raises(paver.OptionError, match="end in .brep"):
        paver.mesh(loose_box(), size=20, repaired=tmp_path / "whole.step")
