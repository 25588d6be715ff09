"""The solver against Mie's series and against itself."""
import os
import sys
import types

import numpy as np
import pytest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:0] = [os.path.join(ROOT, "validation"), os.path.join(ROOT, "bindings")]
import mie  # noqa: E402
import paver  # noqa: E402
import scattering  # noqa: E402

SPHERE = os.path.join(ROOT, "Resources", "examples", "sphere.step")


def sphere(count, **options):
    """A mesh of the unit sphere with about so many elements."""
    whole = paver.mesh(SPHERE, size=1e6)
    radius = np.linalg.norm(whole.nodes - whole.nodes.mean(0), axis=1).max()
    mesh = paver.mesh(SPHERE, size=radius * np.sqrt(4 * np.pi / count), **options)
    nodes = (mesh.nodes - mesh.nodes.mean(0)) / radius
    return types.SimpleNamespace(nodes=nodes, quads=mesh.quads, triangles=mesh.triangles)


def errors(mesh, ka, share=1.0):
    """(unknowns, relative rms of the amplitude along and across the plane of incidence)."""
    functions = scattering.surface(mesh)
    return functions.unknowns, *mie.errors(functions, ka, share)


def test_a_sphere_of_four_hundred_unknowns_is_right_to_a_quarter_of_a_percent():
    unknowns, along, across = errors(sphere(180), 2.01)
    assert unknowns <= 400
    assert np.hypot(along, across) / np.sqrt(2) < 2.3e-3


@pytest.mark.parametrize("ka, share, most", [(0.063, 1, 0.006), (0.063, 0, 0.012), (2.01, 0, 0.03), (2.01, 0.5, 0.02),
                                             (6.04, 1, 0.08), (6.04, 0.5, 0.12)])
def test_all_equations_meet_the_series(ka, share, most):
    _, along, across = errors(sphere(96), ka, share)
    assert max(along, across) < most


def test_errors_fall_with_the_third_power_of_the_size_at_order_two_and_the_second_at_one():
    coarse, fine = sphere(54), sphere(216)
    ratio = max(errors(coarse, 2.01)[1:]) / max(errors(fine, 2.01)[1:])
    assert 5.5 < ratio < 16
    coarse, fine = sphere(54, order=1), sphere(216, order=1)
    assert 3 < max(errors(coarse, 2.01)[1:]) / max(errors(fine, 2.01)[1:]) < 6


def test_triangles_and_quads_meet_the_same_series():
    _, along, across = errors(sphere(96, elements="all-triangle"), 2.01)
    assert max(along, across) < 0.03


def test_the_same_mesh_renumbered_and_turned_gives_the_same():
    mesh = sphere(24)
    angles = np.c_[[0.4, 1.1, 2.0], [0.3, 2.2, 5.0]]
    before = scattering._scattering.Scatterer(scattering.surface(mesh), 2.01).monostatic(angles)
    # A quarter turn about the z axis, elements and nodes backwards.
    last = len(mesh.nodes) - 1
    turned = types.SimpleNamespace(nodes=(mesh.nodes @ np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1.0]]))[::-1],
                                   quads=last - mesh.quads[::-1], triangles=last - mesh.triangles[::-1])
    after = scattering._scattering.Scatterer(scattering.surface(turned), 2.01).monostatic(angles + [0, np.pi / 2])
    assert np.abs(after - before).max() < 1e-10 * np.abs(before).max()


def test_wrong_settings_are_refused_with_a_sentence():
    flat = types.SimpleNamespace(nodes=np.array([[0, 0, 0], [1, 0, 0], [2, 0, 0], [2, 1, 0], [1, 1, 0], [0, 1, 0.0]]),
                                 quads=np.array([[0, 1, 4, 5], [1, 2, 3, 4]]), triangles=np.zeros((0, 3), int))
    functions = scattering.surface(flat)
    assert functions.unknowns == 1
    with pytest.raises(ValueError, match="closed surface"):
        scattering._scattering.Scatterer(functions, 1.0, 0.5)
    with pytest.raises(ValueError, match="wave number"):
        scattering._scattering.Scatterer(functions, 0.0)
