"""Tests of the meshes in the 3D view: `freecad -t TestPaverDisplay`; see TestPaver.py."""
import TestPaver  # noqa: F401, makes the folder of the cases known
from display_cases import *  # noqa: F401, F403
from display_life_cases import *  # noqa: F401, F403
from display_look_cases import *  # noqa: F401, F403
from display_pick_cases import *  # noqa: F401, F403
from mouse_cases import *  # noqa: F401, F403
from out_of_date_cases import OutOfDateView  # noqa: F401
from emphasis_cases import Isolation, LabelsApart, Rings  # noqa: F401
