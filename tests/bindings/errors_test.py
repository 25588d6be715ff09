"""Every error is one sentence of its own class, with code, place and remedy; nothing is left behind."""
import os
import pickle

import pytest

import paver
from paver import _errors, _paver


def test_every_code_of_the_core_has_a_class():
    assert sorted(_errors.CLASSES) == sorted(_paver.exit_codes())
    for code, kind in _errors.CLASSES.items():
        assert issubclass(kind, paver.Error) and kind.__name__ in paver.__all__ and kind.__doc__, code
        assert kind.__module__ == "paver"


def raised(kind, *arguments, **options):
    with pytest.raises(kind) as caught:
        paver.mesh(*arguments, **options)
    error = caught.value
    text = str(error)
    assert text.endswith(".") and "\n" not in text and error.remedy and isinstance(error, paver.Error)
    copy = pickle.loads(pickle.dumps(error))
    assert (type(copy), str(copy), copy.code, copy.remedy) == (type(error), text, error.code, error.remedy)
    return error


def test_arguments_of_other_types(box):
    assert raised(paver.InputError, "", size=5).code == "file_missing"
    assert raised(paver.OptionError, box + "\0", size=5).code == "bad_option"
    assert str(raised(paver.OptionError, box, size=5, local={1: 2})).startswith("local has 1;")
    with pytest.raises(TypeError, match="^labels has None; pass texts.$"):
        paver.Model(open(box, "rb").read(), labels=[None])


def test_content_in_pieces_is_read_whole(box):
    content = open(box, "rb").read()
    spread = bytearray(2 * len(content))
    spread[::2] = content
    checksum = paver.mesh(content, size=5).report["checksum"]
    for view in (memoryview(spread)[::2], memoryview(content[::-1])[::-1]):
        assert paver.mesh(view, size=5).report["checksum"] == checksum


def test_input(tmp_path, box):
    cut = tmp_path / "cut.step"
    cut.write_bytes(open(box, "rb").read()[:3000])
    (tmp_path / "text.step").write_text("no CAD at all")
    for model, code in [(tmp_path / "nowhere.step", "file_missing"), (tmp_path, "file_missing"),
                        (tmp_path / "text.step", "not_a_cad_file"), (cut, "damaged_file")]:
        error = raised(paver.InputError, model, size=5)
        assert error.code == code and os.path.basename(model) in str(error)
    assert raised(paver.InputError, b"", size=5).code == "not_a_cad_file"
    assert raised(paver.InputError, cut.read_bytes(), size=5, name="my part").code == "damaged_file"
    assert "'my part'" in str(raised(paver.InputError, b"nonsense", size=5, name="my part"))


def test_what_cannot_be_meshed_is_a_type_error():
    for thing in (None, 5, [], [5], {}, object()):
        with pytest.raises(TypeError, match=r"cannot be meshed; pass a Part.Shape.*\.$"):
            paver.mesh(thing, size=5)


def test_output(tmp_path, box):
    error = raised(paver.OutputError, box, size=5, output=tmp_path / "no" / "such" / "out.msh")
    assert error.code == "unwritable_output"
    raised(paver.OptionError, box, size=5, output=tmp_path / "out.stl")
    raised(paver.OptionError, box, size=5, output=tmp_path / "out.msh", msh_version="3")
    copy = tmp_path / "box.step"
    copy.write_bytes(open(box, "rb").read())
    assert "is the input" in str(raised(paver.OptionError, copy, size=20, report=copy))
    result = paver.mesh(copy, size=20)
    with pytest.raises(paver.OptionError, match="is the input"):
        result.write(report=copy)
    with pytest.raises(paver.OptionError, match="must end in"):
        result.write(tmp_path / "out.obj")
    assert os.listdir(tmp_path) == ["box.step"]


def test_names_that_are_not_utf_8(tmp_path, box):
    odd = os.fsencode(tmp_path) + b"/K\xf6rper.step"
    with pytest.raises(paver.InputError, match="K\ufffdrper.step' does not exist"):
        paver.mesh(os.fsdecode(odd), size=20)
    content = open(box, "rb").read()
    with open(odd, "wb") as file:
        file.write(content.replace(b"ADVANCED_FACE('',", b"ADVANCED_FACE('Fl\xe4che',"))
    mesh_file = os.fsdecode(os.fsencode(tmp_path) + b"/\xf6.msh")
    result = paver.mesh(os.fsdecode(odd), size=20, output=mesh_file)
    assert "K\ufffdrper" in result.report["model"]["file"] and os.path.getsize(mesh_file) > 0
    assert len(result.face_names) == 6 and "K\ufffdrper" in result.table
    assert [face["label"] for face in result.report["faces"]] == result.face_names


def test_limit(box):
    error = raised(paver.LimitError, box, size=0.1, max_elements=100)
    assert (error.code, error.stage, error.face) == ("too_many_elements", "sizing", None)
    assert error.remedy.startswith("choose a target length of ")


def test_a_face_that_fails_is_named_and_the_rest_delivered(faulty, tmp_path):
    error = raised(paver.FaceError, faulty, size=0.3, output=tmp_path / "rest.msh")
    assert (error.face, error.faces, error.stage) == ("Face2", ("Face2",), "topology")
    assert error.remedy == "trim it in the CAD program"
    assert error.point is None
    rest = paver.mesh(faulty, size=0.3, partial=True)
    assert len(rest.quads) == len(error.result.quads) > 0 and set(rest.quad_faces) == {0}
    assert list(rest.failed_faces) == ["Face2"]
    assert (tmp_path / "rest.msh").stat().st_size > 0
    prediction = paver.predict(faulty, size=0.3)
    assert prediction.face_elements[1] == 0


def test_errors_name_edges_and_points():
    error = _errors.from_core("face_failed", "Text; do this.", "do this", "paving", 11, 6, (1.0, 2.0, 3.0))
    assert (error.face, error.edge, error.point) == ("Face12", "Edge7", (1.0, 2.0, 3.0))
