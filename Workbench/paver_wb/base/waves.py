"""Wavelengths."""
import math

LIGHT = 299792458e3  # mm/s


def wavelength(frequency, eps_r=1.0, mu_r=1.0):
    """mm, of a frequency in Hz in a medium; None where it is not defined."""
    square = eps_r * mu_r
    return LIGHT / (frequency * math.sqrt(square)) if frequency > 0 and square > 0 else None


def wavelength_of(obj):
    """Of a mesh object's frequency in its medium, mm; None without a frequency."""
    frequency = float(getattr(getattr(obj, "Frequency", 0), "Value", 0))
    return wavelength(frequency, float(getattr(obj, "EpsR", 1)), float(getattr(obj, "MuR", 1)))
