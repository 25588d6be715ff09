"""Tests of the workbench that need FreeCAD's window: `freecad -t TestPaverGui`; see TestPaver.py."""
import TestPaver  # noqa: F401, makes the folder of the cases known
from commands_cases import *  # noqa: F401, F403
from create_cases import *  # noqa: F401, F403
from file_task_cases import *  # noqa: F401, F403
from first_use_cases import *  # noqa: F401, F403
from gui_cases import *  # noqa: F401, F403
from out_of_date_cases import OldExport  # noqa: F401
from emphasis_cases import CheckDialog, IsolateCommands  # noqa: F401
from panel_cases import *  # noqa: F401, F403
from panel_log_cases import *  # noqa: F401, F403
from panel_preview_cases import *  # noqa: F401, F403
from panel_run_cases import *  # noqa: F401, F403
from panel_size_cases import *  # noqa: F401, F403
from refinement_panel_cases import *  # noqa: F401, F403
from series_dialog_cases import *  # noqa: F401, F403
from translation_cases import *  # noqa: F401, F403
from units_cases import *  # noqa: F401, F403
from verdict_cases import Verdicts  # noqa: F401
