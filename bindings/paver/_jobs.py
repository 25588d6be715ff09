"""How a run is watched and stopped."""
import threading


class Cancel(threading.Event):
    """A token that stops runs: set() it from any thread, at any time. One token may stop several runs."""


def poll_of(progress, cancel):
    """What the compiled module calls now and then: False stops it."""
    if progress is None and cancel is None:
        return None

    def poll(stage, fraction):
        if cancel is not None and cancel.is_set():
            return False
        return True if progress is None else progress(stage, fraction)
    return poll


def printed(progress):
    """A callback that prints each stage as it begins, and calls `progress`."""
    shown = []

    def show(stage, fraction):
        if shown[-1:] != [stage]:
            shown.append(stage)
            print(stage, flush=True)
        return None if progress is None else progress(stage, fraction)
    return show
