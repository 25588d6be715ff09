"""Meshing with FreeCAD's own progress bar."""
import FreeCAD

from paver_wb import meshing

STEPS = 100


class StatusBar:
    """A progress callback: shows the fraction, and stops the run when the user presses Esc and says yes."""

    def __init__(self, text):
        self.indicator, self.done = FreeCAD.Base.ProgressIndicator(), 0
        self.indicator.start(text, STEPS)

    def __call__(self, stage, fraction):
        wanted = min(int(fraction * STEPS), STEPS)
        try:
            while self.done < wanted:
                self.indicator.next(True)
                self.done += 1
        except RuntimeError:  # how the indicator says that the user has stopped it
            return False
        return None

    def stop(self):
        self.indicator.stop()


def mesh(obj):
    """meshing.mesh with the progress bar; says the outcome in the report view."""
    bar = StatusBar(f"Meshing {obj.Label}...")
    try:
        result = meshing.mesh(obj, progress=bar)
    finally:
        bar.stop()
    FreeCAD.Console.PrintMessage(f"{obj.Label}: {len(result.quads)} quads, {len(result.triangles)} triangles\n")
    for failed in obj.FailedFaces:
        FreeCAD.Console.PrintError(f"{obj.Label}: {failed}\n")
    return result
