"""Arrays: what is in them, that nothing is copied, that they outlive everything else."""
import gc

import numpy as np
import pytest

import paver

ARRAYS = ["nodes", "quads", "triangles", "lines", "quad_faces", "triangle_faces", "line_edges", "further_edges",
          "node_edges", "node_targets"]


@pytest.mark.parametrize("order", [1, 2])
def test_shapes_types_and_content(box, order):
    result = paver.mesh(box, size=10, order=order, elements="all-triangle")
    quads = paver.mesh(box, size=10, order=order)
    assert (result.order, len(result.quads), len(quads.triangles)) == (order, 0, 0)
    nodes, corners = len(quads.nodes), (order + 1) * (order + 2) // 2
    assert quads.nodes.shape == (nodes, 3) and quads.nodes.dtype == np.float64
    assert quads.quads.shape[1] == (order + 1) ** 2 and quads.quads.dtype == np.int32
    assert result.triangles.shape == (2 * len(quads.quads), corners) and result.triangles.dtype == np.int32
    assert quads.lines.shape[1] == order + 1 and quads.lines.dtype == np.int32
    assert quads.triangles.shape == (0, corners) and quads.further_edges.shape == (0, 2)
    assert quads.quad_faces.shape == (len(quads.quads),) and set(quads.quad_faces) == set(range(6))
    assert quads.line_edges.shape == (len(quads.lines),) and set(quads.line_edges) == set(range(12))
    assert quads.node_edges.shape == quads.node_targets.shape == (nodes,)
    for rows in (quads.quads, quads.lines, result.triangles):
        assert rows.min() == 0 or rows is quads.lines
        assert rows.max() < max(nodes, len(result.nodes))
    assert quads.face_names == [f"Face{i}" for i in range(1, 7)]
    assert quads.edge_names == [f"Edge{i}" for i in range(1, 13)]
    assert quads.report["quality"]["quads"] == len(quads.quads) and quads.report["order"] == order


def test_quads_lie_on_the_face_they_name(box):
    result = paver.mesh(box, size=10)
    for face in range(6):
        points = result.nodes[result.quads[result.quad_faces == face].ravel()]
        assert (np.ptp(points, axis=0) < 1e-12).sum() == 1, "a side of a box is flat in one direction"
    middles = result.nodes[result.lines[:, 2]]
    ends = result.nodes[result.lines[:, :2]]
    assert np.allclose(middles, ends.mean(1), atol=1e-12)


def test_nothing_is_copied_and_nothing_can_be_written(example):
    result = paver.mesh(example("plate_nine_holes.step"), size=20)
    for name in ARRAYS:
        one, two = getattr(result, name), getattr(result, name)
        assert not one.flags.owndata or not one.size, name
        assert not one.flags.writeable and one.flags.c_contiguous, name
        if one.size:
            assert one.ctypes.data == two.ctypes.data, name
            with pytest.raises(ValueError):
                one[0] = 0
            with pytest.raises(ValueError):
                one.setflags(write=True)
        with pytest.raises(AttributeError):
            setattr(result, name, two)


def test_arrays_outlive_the_result(example):
    plate = example("plate_nine_holes.step")
    result = paver.mesh(plate, size=20)
    kept = {name: getattr(result, name) for name in ARRAYS}
    copies = {name: array.copy() for name, array in kept.items()}
    quality, cut = result.quality(), result.tessellate(3)
    seen = {name: array.copy() for part in (quality, cut) for name, array in part._asdict().items()}
    del result
    gc.collect()
    other = [paver.mesh(plate, size=18 + i).nodes for i in range(4)]  # takes the memory, were it free
    for name, array in kept.items():
        assert np.array_equal(array, copies[name]), name
    for part in (quality, cut):
        for name, array in part._asdict().items():
            assert np.array_equal(array, seen[name]), name
    assert len(other) == 4


def test_quality_agrees_with_the_report(example):
    result = paver.mesh(example("plate_nine_holes.step"), size=15)
    quality, whole = result.quality(), result.report["quality"]
    assert len(quality.sj) == len(result.quads) + len(result.triangles) == len(quality.validity)
    assert quality.sj.min() == whole["sj"]["all"]["min"]
    assert quality.sj.mean() == pytest.approx(whole["sj"]["all"]["mean"])
    assert quality.jacobian_ratio.min() == whole["min_jacobian_ratio"]
    assert quality.area.sum() == pytest.approx(whole["mesh_area"])
    assert (quality.validity == 1).sum() == whole["inverted"]
    assert quality.sj.ctypes.data == result.quality().sj.ctypes.data, "measured once"
    assert not quality.sj.flags.writeable and quality.validity.dtype == np.int8


def test_tessellation_covers_the_mesh(example):
    result = paver.mesh(example("conesphere.step"), size=12)
    area = result.report["quality"]["mesh_area"]
    for n in (1, 3):
        cut = result.tessellate(n)
        pieces = (2 * len(result.quads) + len(result.triangles)) * n * n
        assert cut.triangles.shape == (pieces, 3) and cut.triangle_elements.shape == (pieces,)
        assert cut.triangle_indices.reshape(-1, 4)[:, 3].tolist() == [-1] * pieces
        assert cut.triangles.ctypes.data == cut.triangle_indices.ctypes.data
        assert cut.outlines.shape == (len(cut.outline_edges), n + 1)
        assert cut.outlines.ctypes.data == cut.outline_indices.ctypes.data
        assert (cut.outline_indices.reshape(-1, n + 2)[:, -1] == -1).all()
        assert cut.points.dtype == cut.normals.dtype == np.float32
        corners = cut.points[cut.triangles].astype(float)
        vectors = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
        assert np.linalg.norm(vectors, axis=1).sum() == pytest.approx(area, rel=0.02 / n)
        assert (np.einsum("ij,ij->i", vectors, cut.normals[cut.triangles[:, 0]]) > 0).all()
        assert np.allclose(np.linalg.norm(cut.normals, axis=1), 1, atol=1e-5)
        assert (np.bincount(cut.outline_edges[cut.outline_edges >= 0]) ==
                np.bincount(result.line_edges, minlength=cut.outline_edges.max() + 1)).all()
        for array in cut:
            assert not array.flags.writeable
    with pytest.raises(paver.OptionError, match="subdivision is 0"):
        result.tessellate(0)


def test_parts_of_a_compound(example):
    model = paver.Model(example("conesphere_gap.step"))
    result = paver.mesh(model, size=20)
    faces = np.concatenate([part.faces for part in result.parts])
    assert sorted(set(faces.tolist())) == list(range(len(result.face_names)))
    assert [len(p.edges) for p in model.parts()] == [len(p.edges) for p in result.parts]
