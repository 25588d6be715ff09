"""Tables of colours: (256, 3) floats from 0 to 1, and colours as Coin packs them."""
import colorsys

import numpy as np

SIZE = 256
# (position, red, green, blue) from bad or low to good or high
STOPS = {
    "Quality": ((0, 0.50, 0.00, 0.15), (0.2, 0.80, 0.10, 0.12), (0.4, 0.96, 0.49, 0.20), (0.6, 0.99, 0.85, 0.40),
                (0.8, 0.66, 0.86, 0.50), (1, 0.20, 0.68, 0.62)),
    "Deviation": ((0, 0.13, 0.30, 0.66), (0.25, 0.44, 0.66, 0.86), (0.5, 0.93, 0.93, 0.91), (0.75, 0.94, 0.56, 0.38),
                  (1, 0.70, 0.09, 0.13)),
    "Viridis": ((0, 0.267, 0.005, 0.329), (0.25, 0.230, 0.322, 0.546), (0.5, 0.128, 0.567, 0.551),
                (0.75, 0.369, 0.789, 0.383), (1, 0.993, 0.906, 0.144)),
    "Rainbow": ((0, 0.10, 0.10, 0.85), (0.25, 0.05, 0.70, 0.90), (0.5, 0.20, 0.80, 0.25), (0.75, 0.95, 0.85, 0.15),
                (1, 0.85, 0.10, 0.10)),
    "Grey": ((0, 0.15, 0.15, 0.15), (1, 0.95, 0.95, 0.95)),
}
NAMES = ("Viridis", "Rainbow", "Grey")  # besides the quantity's own


def table(name):
    """(256, 3) of a map."""
    stops, at = np.array(STOPS[name]), np.linspace(0, 1, SIZE)
    return np.column_stack([np.interp(at, stops[:, 0], stops[:, k]) for k in (1, 2, 3)])


def packed(colours):
    """(n,) uint32, red in the highest byte, opaque, of (n, 3) floats."""
    levels = np.round(np.clip(colours, 0, 1) * 255).astype(np.uint32)
    return levels[:, 0] << 24 | levels[:, 1] << 16 | levels[:, 2] << 8 | np.uint32(255)


def dimmed(colours, factor):
    """Packed colours, darker."""
    bytes_ = np.ascontiguousarray(colours).view(np.uint8).reshape(-1, 4)
    levels = np.arange(256, dtype=np.float32)
    table = np.round(levels * factor).astype(np.uint8)
    made = table[bytes_]
    return made.view(np.uint32).ravel() | np.uint32(255)


def seen_through(colours, opacity):
    """Packed colours that let through what lies behind; opacity: from 0 to 1."""
    return np.asarray(colours, np.uint32) & np.uint32(0xffffff00) | np.uint32(round(255 * opacity))


def distinct(count):
    """`count` colours of which neighbours in the list differ well."""
    golden = 0.61803398875
    return np.array([colorsys.hls_to_rgb((0.58 + i * golden) % 1, (0.62, 0.48, 0.74)[i % 3], 0.58)
                     for i in range(max(count, 1))])
