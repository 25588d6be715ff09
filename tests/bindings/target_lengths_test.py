"""Target lengths at points, before meshing. How turns count: tests/core/sizing/point_lengths_test.cpp."""
import numpy as np
import pytest

import paver


def lengths(name, example, faces, uv, points, **options):
    return paver.target_lengths(example(name), faces, uv, points, **options)


def test_lengths_of_parts_and_of_the_run(example):
    corner = np.array([[0.0, 0, 0]])
    result = paver.mesh(example("box.step"), size=8, local={"Vertex1": 0.5})
    vertex = result.nodes[np.argmin(np.where(result.node_targets > 0, result.node_targets, np.inf))]
    far = result.nodes[np.argmax(np.linalg.norm(result.nodes - vertex, axis=1))]
    found = lengths("box.step", example, [0] * 2, [[1e9, 1e9]] * 2, [vertex, far], size=8, local={"Vertex1": 0.5})
    assert found[0] == pytest.approx(0.5, rel=1e-6) and found[1] == pytest.approx(8), "without (u, v) of the place too"
    assert lengths("box.step", example, [99, -1], [[0, 0]] * 2, np.repeat(corner, 2, 0), size=8).tolist() == [0, 0]


def test_shapes_of_arrays_are_checked(example):
    with pytest.raises(ValueError, match="must be"):
        lengths("box.step", example, [0, 1], [[0, 0]], [[0, 0, 0]], size=8)
    with pytest.raises(paver.OptionError):
        lengths("box.step", example, [0], [[0, 0]], [[0, 0, 0]])


def test_a_prediction_tells_merges_and_contacts_of_the_run(example):
    for name in ("conesphere_gap.step", "box_cylinder.step"):
        for size in (2, 40):
            predicted, report = paver.predict(example(name), size=size), paver.mesh(example(name), size=size).report
            assert [(m["kind"], m["name"], m["into"]) for m in predicted.merges] == [
                (m["kind"], m["name"], m["into"]) for m in report["merges"]]
            assert [list(c["parts"]) for c in predicted.contacts] == [c["parts"] for c in report["model"]["contacts"]]
