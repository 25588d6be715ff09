"""Where the tests find what they share."""
import os
import sys

import pytest

sys.path.append(os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "support"))
import freecad_program  # noqa: E402


@pytest.fixture
def home(tmp_path):
    """A private profile of FreeCAD; skips without FreeCAD, and in CI nothing may be missing."""
    if not freecad_program.program():
        (pytest.fail if os.environ.get("CI") == "true" else pytest.skip)("FreeCAD is not installed")
    return freecad_program.profile(tmp_path / "profile")
