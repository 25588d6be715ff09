"""Tests of the workbench: `freecadcmd -t TestPaver`. The cases lie in tests/workbench of the checkout."""
import os
import sys

CASES = os.path.join(os.path.dirname(os.path.dirname(os.path.realpath(__file__))), "tests", "workbench")
if CASES not in sys.path:
    sys.path.append(CASES)

from addon_cases import *  # noqa: E402, F401, F403
from analysis_cases import *  # noqa: E402, F401, F403
from child_cases import *  # noqa: E402, F401, F403
from expression_cases import *  # noqa: E402, F401, F403
from files_cases import *  # noqa: E402, F401, F403
from look_cases import *  # noqa: E402, F401, F403
from mesh_cases import *  # noqa: E402, F401, F403
from named_cases import *  # noqa: E402, F401, F403
from place_cases import *  # noqa: E402, F401, F403
from refinement_cases import *  # noqa: E402, F401, F403
from series_cases import *  # noqa: E402, F401, F403
from state_cases import *  # noqa: E402, F401, F403
