"""A mesh from arrays is measured, drawn and picked as the result that the arrays came from."""
import numpy as np
import pytest

import paver

ARRAYS = ("nodes", "quads", "triangles", "quad_faces", "triangle_faces", "lines", "line_edges")


@pytest.fixture
def result(example):
    return paver.mesh(example("conesphere.step"), size=60)


def arrays_of(result, **other):
    return {"order": result.order, **{name: getattr(result, name) for name in ARRAYS}, **other}


def expect_equal(one, two):
    for name in one._fields:
        np.testing.assert_array_equal(getattr(one, name), getattr(two, name), name)


def test_it_measures_and_draws_like_the_result(result):
    mesh = paver.SurfaceMesh(**arrays_of(result))
    expect_equal(mesh.quality(), result.quality())
    for apart in (False, True):
        expect_equal(mesh.tessellate(2, apart), result.tessellate(2, apart))


def test_free_edges_are_where_a_face_is_missing(result):
    is_kept = result.quad_faces > 0
    mesh = paver.SurfaceMesh(**arrays_of(result, quads=result.quads[is_kept], quad_faces=result.quad_faces[is_kept]))
    assert (result.tessellate(1).outline_elements == 2).all()
    drawn = mesh.tessellate(1)
    is_free = drawn.outline_elements == 1
    assert is_free.any() and (drawn.outline_edges[is_free] >= 0).all()


def test_it_writes_what_the_result_writes(result, tmp_path):
    names = {"face_names": result.face_names, "edge_names": result.edge_names}
    for ending, more in (("vtu", {}), ("msh", {}), ("msh", {"msh_version": "2.2", "ascii": True})):
        one, two = tmp_path / f"one.{ending}", tmp_path / f"two.{ending}"
        result.write(one, **more)
        paver.SurfaceMesh(**arrays_of(result)).write(two, **names, **more)
        assert one.read_bytes() == two.read_bytes()
    with pytest.raises(paver.OptionError, match="must end in .msh or .vtu"):
        paver.SurfaceMesh(**arrays_of(result)).write(tmp_path / "mesh.stl")
    with pytest.raises(paver.OutputError):
        paver.SurfaceMesh(**arrays_of(result)).write(tmp_path / "no" / "mesh.msh")


@pytest.mark.parametrize("name, value", [
    ("order", 0), ("nodes", np.zeros((3, 2))), ("quads", np.zeros((2, 9), np.int32) - 1),
    ("quads", np.full((2, 9), 10**6, np.int32)), ("quads", np.zeros((2, 8), np.int32)),
    ("quad_faces", np.zeros(1, np.int32)), ("line_edges", np.zeros(0, np.int32)), ("triangles", np.zeros(6, np.int32))])
def test_arrays_that_do_not_fit_are_named(result, name, value):
    with pytest.raises(ValueError, match="^" + name):
        paver.SurfaceMesh(**arrays_of(result, **{name: value}))


@pytest.mark.parametrize("name", ["quads", "quad_faces", "line_edges"])
def test_numbers_are_neither_cut_nor_wrapped_round(result, name):
    numbers = getattr(result, name)
    for wrong in (numbers + 0.5, numbers.astype("i8") + 2**32, numbers.astype("i8") - 2**32, numbers > 0):
        with pytest.raises(ValueError, match=f"^{name} has .*\\.$"):
            paver.SurfaceMesh(**arrays_of(result, **{name: wrong}))
    paver.SurfaceMesh(**arrays_of(result, **{name: numbers.astype("i8")}))


def test_other_arguments_are_refused_in_a_sentence(result, tmp_path):
    mesh = paver.SurfaceMesh(**arrays_of(result))
    for drawn in (mesh, result):
        with pytest.raises(TypeError, match="^subdivision is 2.5; write a whole number.$"):
            drawn.tessellate(2.5)
        with pytest.raises(paver.OptionError, match="has a NUL character; leave it out.$"):
            drawn.write(tmp_path / "mesh\0.msh")
    assert not list(tmp_path.iterdir())


def test_the_element_under_a_ray(result):
    drawn = result.tessellate(2, apart=True)
    tree = paver.PickTree(drawn)
    corners = drawn.points[drawn.triangles].astype(float)
    for triangle in range(0, len(drawn.triangles), 7):
        centre, normal = corners[triangle].mean(0), drawn.normals[drawn.triangles[triangle, 0]]
        (hit, along), *_ = tree.hits(centre + normal, -2 * normal)
        assert hit == triangle and along == pytest.approx(0.5, abs=1e-4)
    assert tree.hits((0, 0, 1e6), (0, 0, 1)) == []


def test_a_tree_of_wrong_indices_is_refused(result):
    drawn = result.tessellate(1)
    with pytest.raises(ValueError, match="points"):
        paver.PickTree(drawn._replace(points=drawn.points[:10]))
    with pytest.raises(ValueError, match="triangle_indices"):
        paver.PickTree(drawn._replace(triangle_indices=drawn.triangle_indices[:-1]))
