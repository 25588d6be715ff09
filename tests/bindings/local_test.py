"""Target lengths of parts: as asked at the part, graded around it, in meshes as sound as without."""
import numpy as np
import pytest

import paver

# model, target length, parts with their lengths
CASES = [("box.step", 8, {"Face1": 0.8}), ("box.step", 8, {"Edge1": 0.8, "Vertex8": 0.4}),
         ("plate_nine_holes.step", 19, {"Vertex1": 0.5}), ("plate_nine_holes.step", 19, {"Edge1": 1.9}),
         ("sphere.step", 20, {"Face1": 4}), ("conesphere.step", 20, {"Face1": 4}), ("wing.step", 30, {"Edge1": 3}),
         ("box_cylinder.step", 12, {"Face1": 1.5}), ("pyramid.step", 10, {"Edge1": 1}),
         ("wavy_patch.step", 22, {"Face1": 5, "Vertex1": 1})]
GRADATION = 0.6  # the default


def edges_of(result):
    """(m, 2) rows of nodes: every edge of the mesh once, between corners."""
    sides = [np.stack([rows[:, k], rows[:, (k + 1) % corners]], 1)
             for rows, corners in ((result.quads, 4), (result.triangles, 3)) for k in range(corners)]
    return np.unique(np.sort(np.concatenate(sides), axis=1), axis=0)


def lengths(result, edges):
    return np.linalg.norm(result.nodes[edges[:, 0]] - result.nodes[edges[:, 1]], axis=1)


def edges_on(result, part):
    """Mesh edges on a face or an edge of the model."""
    number = int(part.lstrip("FaceEdge")) - 1
    if part.startswith("Edge"):
        return result.lines[result.line_edges == number][:, :2]
    rows = result.quads[result.quad_faces == number]
    return np.unique(np.sort(np.concatenate([rows[:, [k, (k + 1) % 4]] for k in range(4)]), axis=1), axis=0)


@pytest.mark.parametrize("name, size, local", CASES)
def test_parts_have_their_lengths_in_sound_meshes(name, size, local, example):
    model = paver.Model(example(name))
    plain, result = paver.mesh(model, size=size), paver.mesh(model, size=size, local=local)
    quality = result.report["quality"]
    assert quality["inverted"] == quality["undecided"] == quality["nonmanifold_edges"] == 0
    assert quality["watertight"] == plain.report["quality"]["watertight"]
    assert quality["mesh_area"] == pytest.approx(quality["cad_area"], rel=0.01)
    assert quality["sj"]["all"]["min"] > 0.15
    assert len(result.quads) > len(plain.quads) - 20  # a point in a corner moves the counts elsewhere a little
    for part, length in local.items():
        if not part.startswith("Vertex"):
            measured = lengths(result, edges_on(result, part))
            assert len(measured) > 3
            assert 0.75 * length < np.median(measured) < 1.25 * length, part
    again = paver.mesh(model, size=size, local=local, threads=1)
    assert again.report["checksum"] == result.report["checksum"]
    assert paver.mesh(model, size=size, local=local, threads=2).report["checksum"] == result.report["checksum"]


def test_lengths_grow_with_the_distance(example):
    size, least = 12.0, 0.5
    for gradation in (0.3, GRADATION):
        result = paver.mesh(example("box.step"), size=size, gradation=gradation, local={"Vertex1": least})
        corners = result.nodes[np.unique(result.quads[:, :4])]
        vertex = corners[np.argmin(result.node_targets[np.unique(result.quads[:, :4])])]
        edges = edges_of(result)
        middle = result.nodes[edges].mean(axis=1)
        asked = np.minimum(size, least + gradation * np.linalg.norm(middle - vertex, axis=1))
        ratio = lengths(result, edges) / asked
        assert 0.75 < np.median(ratio[asked < size]) < 1.3
        assert ratio.max() < 2.5 and ratio[asked < size].min() > 0.3
        assert lengths(result, edges).min() < 1.5 * least


def test_prediction_counts_them(example):
    for name, size, local in CASES:
        model = paver.Model(example(name))
        predicted = paver.predict(model, size=size, local=local).elements
        result = paver.mesh(model, size=size, local=local)
        assert 0.5 < (len(result.quads) + len(result.triangles)) / predicted < 1.7, (name, local)


def test_the_ways_to_write_them(box):
    expected = paver.mesh(box, size=20, local={"Face1": 4, "Edge5": 2, "Vertex2": 2}).report["checksum"]
    for local in ("Face1=4;Edge5,Vertex2=2", ["Face1=4mm", "Edge5,Vertex2=2"],
                  {"Face1": "4 mm", ("Edge5", "Vertex2"): "0.2 cm"}, {"Face1": 4, "Edge5,Vertex2": 2.0}):
        assert paver.mesh(box, size=20, local=local).report["checksum"] == expected
    plain = paver.mesh(box, size=20).report["checksum"]
    assert paver.mesh(box, size=20, local={}).report["checksum"] == plain
    report = paver.mesh(box, size=20, local={"Face1": 25}).report
    assert (report["checksum"], len(report["notes"])) == (plain, 1)
    solid = paver.mesh(box, frequency="1 GHz", local={"Solid1": {"eps_r": 9}})
    assert paver.mesh(box, frequency="1 GHz", local="Solid1=eps-r:9").report["checksum"] == solid.report["checksum"]


def test_a_length_that_is_only_come_near_to_is_noted(example):
    report = paver.mesh(example("sphere.step"), size=20, local={"Edge1": 5}).report
    assert (len(report["notes"]), "Edge1" in report["notes"][0]) == (1, True)
    assert paver.mesh(example("box.step"), size=20, local={"Edge1": 8}).report["notes"] == []
    notes = paver.mesh(example("box.step"), size=20, local={"Edge1": 5}).report["notes"]
    assert all(note.startswith("Elements repaired") for note in notes)


@pytest.mark.parametrize("local, says", [
    ({"Face7": 1}, "local names Face7, but the model has Face1 to Face6"), ({"Face1": 0}, "local Face1 is 0 mm"),
    ({"Face1": "-1 mm"}, "local Face1 is -1 mm"), ({"Lid": 1}, "'Lid', which is no part of a model"),
    ({"Face1": "1 GHz"}, "write it like"), ({"Solid1": {"eps_r": 4}}, "needs frequency"), ("Face1", "write it like"),
    ({"Face1": None}, "local is None")])
def test_bad_ones_are_refused(local, says, box):
    with pytest.raises(paver.OptionError, match=says) as caught:
        paver.mesh(box, size=20, local=local)
    assert caught.value.remedy


@pytest.mark.parametrize("name,size,most,order", [("conesphere.step", 40, 0.02, 2), ("wavy_patch.step", 60, 0.2, 2),
                                                  ("box_cylinder.step", 30, 0.3, 1)])
def test_chord_error_is_kept(example, name, size, most, order):
    plain = paver.mesh(example(name), size=size, order=order).report
    report = paver.mesh(example(name), size=size, order=order, chord_error=most).report
    assert plain["quality"]["distance"]["largest"] > most >= report["quality"]["distance"]["largest"]
    assert all(face["distance"]["largest"] <= most for face in report["faces"])
    assert report["verdict"] == "sound"
    assert not any("chord_error" in note for note in report["notes"])


def test_where_chord_error_is_not_kept_is_said(example):
    report = paver.mesh(example("conesphere.step"), size=40, chord_error=1e-6, max_elements=3000).report
    assert report["quality"]["distance"]["largest"] > 1e-6
    assert any("above chord_error 1e-06 mm" in note for note in report["notes"])
    assert report["quality"]["quads"] < 3500
