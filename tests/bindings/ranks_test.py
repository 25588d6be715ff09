"""paver.mesh in several processes: the same result, errors and cancel as in this one."""
import os
import subprocess

import numpy as np
import pytest

import paver
from conftest import FAULTY_BREP

BUILD = os.environ.get("PAVER_BUILD") or os.path.join(os.path.dirname(__file__), "../../build")
pytestmark = pytest.mark.skipif(not os.path.exists(os.path.join(BUILD, "core", "paver-worker")),
                                reason="Paver was built without MPI")
ARRAYS = ("nodes", "quads", "triangles", "quad_faces", "triangle_faces", "lines", "line_edges", "further_edges",
          "node_edges", "node_targets")


def without_costs(report):
    return {key: value for key, value in report.items() if key not in ("stage_seconds", "peak_memory_mib", "threads", "tasks")}


@pytest.fixture(autouse=True)
def temporary_folder(tmp_path, monkeypatch):
    """Nothing may be left there."""
    folder = tmp_path / "tmp"
    folder.mkdir()
    monkeypatch.setenv("TMPDIR", str(folder))
    yield folder
    assert os.listdir(folder) == []


@pytest.mark.parametrize("ranks", [1, 3])
@pytest.mark.parametrize("order", [1, 2])
def test_the_result_is_that_of_one_process(example, ranks, order):
    one = paver.mesh(example("wing.step"), size=20, order=order)
    several = paver.mesh(example("wing.step"), size=20, order=order, ranks=ranks)
    for name in ARRAYS:
        assert np.array_equal(getattr(one, name), getattr(several, name)), name
    assert without_costs(one.report) == without_costs(several.report)
    assert np.array_equal(one.quality().sj, several.quality().sj)


def test_bytes_and_a_model_that_was_read_before(box):
    with open(box, "rb") as f:
        model = paver.Model(f.read(), name="the box")
    paver.predict(model, size=10)
    one, several = paver.mesh(model, size=10), paver.mesh(model, size=10, ranks=2)
    assert without_costs(one.report) == without_costs(several.report)
    assert several.report["model"]["file"] == "the box"


def test_errors(box, tmp_path):
    for value in (-1, 1.5, "two", True):
        with pytest.raises(paver.OptionError, match="ranks is"):
            paver.mesh(box, size=10, ranks=value)
    with pytest.raises(paver.InputError, match="does not exist"):
        paver.mesh(str(tmp_path / "nowhere.step"), size=10, ranks=2)
    with pytest.raises(paver.LimitError):
        paver.mesh(box, size=1, max_elements=10, ranks=2)


def test_a_face_that_fails_is_named_and_the_others_delivered():
    with pytest.raises(paver.FaceError) as one:
        paver.mesh(FAULTY_BREP, size=0.3)
    with pytest.raises(paver.FaceError) as several:
        paver.mesh(FAULTY_BREP, size=0.3, ranks=2)
    assert str(several.value) == str(one.value) and several.value.faces == one.value.faces
    assert len(several.value.result.quads) == len(one.value.result.quads) > 0


def test_cancel_and_exceptions_stop_the_ranks(example):
    def stop(stage, fraction):
        return stage != "paving"
    with pytest.raises(paver.Cancelled):
        paver.mesh(example("wing.step"), size=0.4, multilevel="off", ranks=3, progress=stop)

    def fail(stage, fraction):
        if stage == "paving":
            raise KeyError("mine")
    with pytest.raises(KeyError):
        paver.mesh(example("wing.step"), size=0.4, multilevel="off", ranks=2, progress=fail)
    children = subprocess.run(["ps", "--ppid", str(os.getpid()), "-o", "args="], capture_output=True, text=True).stdout
    assert "worker" not in children
