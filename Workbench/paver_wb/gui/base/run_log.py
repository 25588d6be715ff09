"""What a run has done and is doing, as lines: its stages with their seconds, and what came of it. It stays until the next run of
the same object, whether a panel shows it or not."""
import time

from paver_wb.gui.base import run_status

MOST_LINES = 200
_logs = {}  # (names of document and object): the RunLog of the last run


class RunLog:
    """`changed`: called when text() is another one."""

    def __init__(self):
        self.lines, self.stage, self.begun, self.fraction, self.changed = [], None, 0.0, 0.0, lambda: None

    def note(self, text):
        """Another line, with the time of day."""
        self.end_stage()
        self.add(text)
        self.changed()

    def add(self, text):
        self.lines = [*self.lines, time.strftime("%H:%M:%S  ") + text][-MOST_LINES:]

    def tell(self, stage, fraction):
        """How far a run is."""
        if stage != self.stage:
            self.end_stage()
            self.add(run_status.stage_text(stage))
            self.stage, self.begun = stage, time.monotonic()
        self.fraction = fraction
        self.changed()

    def end_stage(self):
        """Puts its seconds behind the stage that has been at work."""
        if self.stage is not None:
            self.lines[-1] += f"  {time.monotonic() - self.begun:.1f} s"
            self.stage = None

    def text(self):
        """With the share that is done of the stage at work."""
        live = f"  {100 * self.fraction:.0f} %" if self.stage is not None and self.fraction > 0 else ""
        return "\n".join(self.lines) + live


def new(obj):
    """The log of a run that begins, in place of that of the one before."""
    _logs[obj.Document.Name, obj.Name] = RunLog()
    return of(obj)


def of(obj):
    """The log of an object's last run, or None."""
    return _logs.get((obj.Document.Name, obj.Name))


def forget(document):
    """Those of a document that was closed."""
    for key in [key for key in _logs if key[0] == document]:
        del _logs[key]
