"""Bodies of revolution without a mesh: against Mie's series, and the integrals against those of scipy."""
import os
import sys

import numpy as np
import pytest
from scipy.integrate import quad

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:0] = [os.path.join(ROOT, "validation"), os.path.join(ROOT, "bindings")]
import mie  # noqa: E402
import revolved  # noqa: E402
from series import body, conesphere  # noqa: E402
import stored  # noqa: E402

ANGLES = np.radians([0, 40, 90, 150])


def sphere(count):
    angles = np.linspace(0, np.pi, count + 1)
    return np.c_[np.cos(angles), np.abs(np.sin(angles)) * (np.arange(count + 1) % count > 0)]


def error(ka, count, modes):
    """Largest relative error of the amplitude back to where waves come from."""
    found = np.abs(revolved.monostatic(sphere(count), ka, ANGLES, modes)) * ka
    return np.abs(found / np.abs(mie.amplitudes(ka, np.pi)[0][0]) - 1).max()


def test_a_sphere_meets_the_series_with_the_square_of_the_segments():
    coarse, fine = error(2.01, 24, 6), error(2.01, 48, 6)
    assert fine < 3e-3
    assert 3 < coarse / fine < 5


def test_modes_are_missed_where_there_are_too_few():
    assert error(6.04, 48, 11) < 2e-3 < 1e-2 < error(6.04, 48, 5)


@pytest.mark.parametrize("away", [1e-5, 0.01, 0.3, 2])
def test_kernels_are_the_integrals_of_the_angle(away):
    rho, rho2, z, k, modes = 1.0, 1.0 + 0.6 * away, 0.8 * away, 4.0, 9

    def value(angle, m):
        r = np.sqrt((rho - rho2) ** 2 + z ** 2 + 4 * rho * rho2 * np.sin(angle / 2) ** 2)
        return np.exp(-1j * k * r) / (2 * np.pi * r) * np.cos(m * angle)

    found = revolved.kernels(*(np.array([x]) for x in (rho, 0.0, rho2, z)), k, modes)[:, 0]
    for m in range(modes):
        exact = [quad(lambda a: getattr(value(a, m), part), 0, np.pi, points=[away, 10 * away], limit=400, epsabs=1e-11)[0]
                 for part in ("real", "imag")]
        assert abs(found[m] - complex(*exact)) < 1e-7 * abs(found[0])


def test_the_outline_of_the_cone_sphere_goes_from_axis_to_axis_through_the_slot():
    nodes = conesphere.outline(20)
    assert (nodes[[0, -1], 1] == 0).all() and (nodes[1:-1, 1] > 0).all()
    assert nodes[0, 0] == conesphere.TIP and np.isclose(nodes[-1, 0], conesphere.MIDDLE + conesphere.RADIUS)
    assert np.hypot(*np.diff(nodes, axis=0).T).max() <= 20 * 1.001
    assert {conesphere.FLOOR} < set(nodes[np.isclose(nodes[:, 0], conesphere.SLOT), 1])


def test_a_coarse_mesh_comes_near_it(tmp_path):
    found = stored.Stored(str(tmp_path / "found.json"))
    exact = conesphere.without_mesh(found, 3e8, 20, 4)
    mesh = body.meshes.ours(conesphere.BODY.model, 60)
    assert max(body.differences(body.solved(mesh, 3e8, conesphere.BODY.angles), exact)) < 0.1
