"""The mesh of several ranks is that of one process, bit for bit, for every number of ranks and threads."""
import json
import os
import subprocess

import pytest

from processes import PROGRAM, runs

MODELS = {
    "wing.step": ("--size", "8", "--local", "Face1=3mm"),
    "box_cylinder.step": ("--size", "6", "--elements", "all-quad"),
    "conesphere_gap.step": ("--size", "20", "--multilevel", "4"),
    "torus.step": ("--size", "5", "--order", "1"),
}
CAD = {"nist_ctc_01.brep": ("--size", "20"), "truncated_cone.igs": ("--size", "30"),
       "sliced_cylinder.step": ("--size", "10"), "nacelle.stp": ("--size", "60")}


def mesh(model, folder, name, *options, ending=".msh"):
    """(bytes of the mesh, report less what differs from run to run)."""
    out, report = os.path.join(folder, name + ending), os.path.join(folder, name + ".json")
    done = subprocess.run([PROGRAM, "mesh", model, "-o", out, "--report", report, "--quiet", *options],
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    with open(report) as f:
        figures = json.load(f)
    assert figures["stage_seconds"] and figures["peak_memory_mib"] > 0
    for name in ("stage_seconds", "peak_memory_mib", "threads", "tasks"):
        del figures[name]
    with open(out, "rb") as f:
        return f.read(), figures


def compare(model, folder, options, ending=".msh"):
    expected = mesh(model, folder, "one", *options, ending=ending)
    for ranks, threads in ((1, 2), (2, 1), (3, 2), (5, 1)):
        found = mesh(model, folder, "several", *options, "--ranks", str(ranks), "--threads", str(threads), ending=ending)
        assert found[1] == expected[1], (ranks, threads)
        assert found[0] == expected[0], (ranks, threads)


@pytest.mark.parametrize("name", MODELS)
def test_examples(name, tmp_path):
    compare(os.path.join(runs.EXAMPLES, name), str(tmp_path), MODELS[name])


@pytest.mark.parametrize("name", CAD)
def test_cad_models(name, tmp_path):
    model = os.path.join(runs.SHARED, "cad", name)
    if not os.path.exists(model):
        pytest.skip(f"needs a real model, cad/{name} is missing: set PAVER_SHARED to the folder that has it")
    compare(model, str(tmp_path), CAD[name])


@pytest.mark.parametrize("ending", (".msh", ".vtu"))
def test_a_model_of_wires_only(ending, tmp_path):
    compare(os.path.join(os.path.dirname(__file__), "wire.brep"), str(tmp_path), ("--size", "4"), ending)
