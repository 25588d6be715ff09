"""Radar cross-sections of meshes: arrays of a mesh to decibels, and what two curves differ by."""
import os
import sys

import numpy as np

_ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(os.environ.get("PAVER_BUILD") or os.path.join(_ROOT, "build"), "validation"))
import _scattering  # noqa: E402

LIGHT = 299_792_458e3  # mm/s


def surface(mesh):
    """Rooftop functions on a mesh with `nodes` (n, 3), `quads` (m, 4 | 9 | 16) and `triangles` (k, 3 | 6 | 10)."""
    return _scattering.Surface(np.asarray(mesh.nodes, float), np.asarray(mesh.quads, np.int32),
                               np.asarray(mesh.triangles, np.int32))


def scatterer(functions, frequency, electric_share=1.0, **settings):
    """The equation of `surface()` in free space, filled and factorised; lengths in mm, frequency in Hz."""
    return _scattering.Scatterer(functions, 2 * np.pi * frequency / LIGHT, electric_share, **settings)


def monostatic(equation, angles):
    """(VV, HH) in dBsm for waves from the directions `angles` (n, 2): theta and phi, radians."""
    amplitudes = equation.monostatic(np.asarray(angles, float))
    return 10 * np.log10(4 * np.pi * np.abs(amplitudes) ** 2 * 1e-6)


def difference(curve, reference, depth=80):
    """Mean of |curve - reference| in dB, both clipped `depth` below the reference's peak; per column."""
    least = reference.max(0) - depth
    return np.abs(np.maximum(curve, least) - np.maximum(reference, least)).mean(0)
