"""How long a run will still take, from the share of it that is done and the time that has passed."""
import math

import FreeCAD

SOONEST, LEAST_SHARE = 3.0, 0.06  # seconds, and share of a run, before which nothing can be told
SMOOTHING = 0.15  # share of a run in which an estimate forgets most of those before
FEW, STEP = 8, 5  # seconds
translate = FreeCAD.Qt.translate


class TimeLeft:
    """left() asks again and again: shares that rise by jumps make no estimate that jumps."""

    def __init__(self):
        self.total, self.share = None, 0.0

    def left(self, share, passed):
        """Seconds; None while nothing can be told, as before much is done, or when an estimate is over and the run is not.
        share: of the run, 0 to 1; passed: seconds since it began."""
        if share < LEAST_SHARE or passed < SOONEST:
            return None
        now = passed / share
        if self.total is None:
            self.total, self.share = now, share
        elif share > self.share:  # what stands still tells nothing new
            self.total += (now - self.total) * (1 - math.exp((self.share - share) / SMOOTHING))
            self.share = share
        return self.total - passed if self.total > passed else None


def text_of(seconds):
    """As users read it; empty for None."""
    if seconds is None:
        return ""
    if seconds < FEW:
        return translate("Paver", "a few seconds left")
    if seconds < 60 - STEP / 2:
        return translate("Paver", "about {} s left").format(STEP * round(seconds / STEP))
    if seconds < 5400:
        return translate("Paver", "about {} min left").format(max(1, round(seconds / 60)))
    return translate("Paver", "about {} h left").format(f"{seconds / 3600:.2g}")
