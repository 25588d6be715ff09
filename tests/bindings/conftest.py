"""Puts the package on sys.path; small models that tests share."""
import os
import sys

import pytest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BINDINGS = os.path.join(ROOT, "bindings")
sys.path[:0] = [BINDINGS, os.path.join(ROOT, "tests", "support")]


@pytest.fixture
def example():
    """Path of a model of Resources/examples by its file name."""
    return lambda name: os.path.join(ROOT, "Resources", "examples", name)


@pytest.fixture
def box(example):
    return example("box.step")


@pytest.fixture
def program():
    """The command line."""
    return os.environ.get("PAVER_PROGRAM") or os.path.join(ROOT, "build", "core", "paver")


# A unit square, and an infinite plane that no mesh can cover.
FAULTY_BREP = b"""
CASCADE Topology V1, (c) Matra-Datavision
Locations 0
Curve2ds 0
Curves 4
1 0 0 0 1 0 0
1 1 0 0 0 1 0
1 1 1 0 -1 0 0
1 0 1 0 0 -1 0
Polygon3D 0
PolygonOnTriangulations 0
Surfaces 2
1 0.5 0.5 0 0 0 1 1 0 -0 -0 1 0
1 0 0 0 0 0 1 1 0 0 0 1 0
Triangulations 0

TShapes 12
Ve
1e-07
0 0 0
0 0

0101101
*
Ve
1e-07
1 0 0
0 0

0101101
*
Ed
 1e-07 1 1 0
1  1 0 0 1
0

0101000
+12 0 -11 0 *
Ve
1e-07
1 1 0
0 0

0101101
*
Ed
 1e-07 1 1 0
1  2 0 0 1
0

0101000
+11 0 -9 0 *
Ve
1e-07
0 1 0
0 0

0101101
*
Ed
 1e-07 1 1 0
1  3 0 0 1
0

0101000
+9 0 -7 0 *
Ed
 1e-07 1 1 0
1  4 0 0 1
0

0101000
+7 0 -12 0 *
Wi

0101100
+10 0 +8 0 +6 0 +5 0 *
Fa
0  1e-07 1 0

0101000
+4 0 *
Fa
0  1e-07 2 0

0101000
*
Co

1100000
+3 0 +2 0 *

+1 0
"""


@pytest.fixture
def faulty():
    """Bytes of a model whose Face2 cannot be meshed."""
    return FAULTY_BREP
