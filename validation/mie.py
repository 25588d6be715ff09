"""Scattering by a perfectly conducting sphere, exactly: Mie's series [Bohren83]."""
import numpy as np
from scipy.special import spherical_jn, spherical_yn

import scattering


def amplitudes(ka, angles):
    """(S1, S2) at scattering angles from forward (radians): across and along the plane of incidence. The radar cross-section
    is 4 pi / k^2 |S|^2."""
    angles = np.atleast_1d(np.asarray(angles, float))
    terms = int(ka + 4 * ka ** (1 / 3) + 10)
    n = np.arange(1, terms + 1)
    j, y = spherical_jn(n, ka), spherical_yn(n, ka)
    h = j - 1j * y
    slope_j = j + ka * spherical_jn(n, ka, derivative=True)
    slope_h = slope_j - 1j * (y + ka * spherical_yn(n, ka, derivative=True))
    a, b = slope_j / slope_h, j / h
    cosine = np.cos(angles)
    below, here = np.zeros_like(angles), np.ones_like(angles)  # pi_0, pi_1
    across, along = np.zeros(angles.shape, complex), np.zeros(angles.shape, complex)
    for i in n:
        slope = i * cosine * here - (i + 1) * below
        factor = (2 * i + 1) / (i * (i + 1))
        across += factor * (a[i - 1] * here + b[i - 1] * slope)
        along += factor * (a[i - 1] * slope + b[i - 1] * here)
        below, here = here, ((2 * i + 1) * cosine * here - (i + 1) * below) / i
    return across, along


def errors(functions, ka, share=1.0, threads=0):
    """Relative rms of the amplitude of a unit sphere along and across the plane of incidence; `functions` of its mesh."""
    equation = scattering._scattering.Scatterer(functions, ka, share, threads)
    theta = np.radians(np.arange(0, 181, 3.0))
    along = equation.bistatic([0, 0], 0, np.c_[theta, 0 * theta])[:, 0]
    across = equation.bistatic([0, 0], 0, np.c_[theta, 0 * theta + np.pi / 2])[:, 1]
    exact_across, exact_along = amplitudes(ka, np.pi - theta)
    return tuple(np.sqrt(np.mean((np.abs(found) * ka - np.abs(exact)) ** 2) / np.mean(np.abs(exact) ** 2))
                 for found, exact in ((along, exact_along), (across, exact_across)))
