"""Progress, cancel, threads, signals."""
import os
import subprocess
import sys
import threading
import time

import pytest

import paver
from conftest import BINDINGS

STAGES = ["read", "topology", "sizing", "boundary", "regions", "paving", "repair", "join", "curving", "quality", "write", "done"]
LONG = {"size": 0.1, "max_elements": 100_000_000}  # of the plate: many seconds


@pytest.fixture
def plate(example):
    return example("plate_circular_hole.step")


def test_progress_tells_stages_and_fractions(plate):
    calls = []
    paver.mesh(plate, size=2, progress=lambda stage, fraction: calls.append((stage, fraction)))
    assert calls[0] == ("read", 0) and calls[-1] == ("done", 1)
    assert all(stage in STAGES and 0 <= fraction <= 1 for stage, fraction in calls)
    assert threading.get_ident() == calls_thread(plate)


def calls_thread(model):
    seen = set()
    paver.mesh(model, size=20, progress=lambda *_: seen.add(threading.get_ident()))
    assert len(seen) == 1
    return seen.pop()


@pytest.mark.parametrize("after", [1, 2, 5])
def test_false_from_the_callback_cancels(plate, after, tmp_path):
    calls = []

    def progress(*call):
        calls.append(call)
        return len(calls) < after
    with pytest.raises(paver.Cancelled) as caught:
        paver.mesh(plate, progress=progress, output=tmp_path / "out.msh", **LONG)
    assert caught.value.code == "cancelled"
    assert len(calls) == after, "nobody is asked again"
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize("after", [1, 3])
def test_an_exception_in_the_callback_cancels_and_comes_through(plate, after):
    class Mine(Exception):
        pass
    calls, mine = [], Mine("mine")

    def progress(*call):
        calls.append(call)
        if len(calls) == after:
            raise mine
    with pytest.raises(Mine) as caught:
        paver.mesh(plate, progress=progress, **LONG)
    assert caught.value is mine


@pytest.mark.parametrize("token", [paver.Cancel, threading.Event])
def test_a_token_cancels_from_another_thread(plate, token):
    cancel, started = token(), threading.Event()
    thread = threading.Thread(target=lambda: (started.wait(), cancel.set()))
    thread.start()
    with pytest.raises(paver.Cancelled):
        paver.mesh(plate, cancel=cancel, progress=lambda *_: started.set(), **LONG)
    thread.join()
    with pytest.raises(paver.Cancelled):
        paver.mesh(plate, size=20, cancel=cancel)
    for function in (paver.predict, paver.Model(plate).parts):
        with pytest.raises(paver.Cancelled):
            function(*([plate] if function is paver.predict else []), cancel=cancel,
                     **({"size": 20} if function is paver.predict else {}))
    cancel.clear()
    assert len(paver.mesh(plate, size=20, cancel=cancel).quads) > 0


def test_a_cancelled_write_leaves_nothing(plate, tmp_path):
    result = paver.mesh(plate, size=20)
    with pytest.raises(paver.Cancelled):
        result.write(tmp_path / "out.msh", progress=lambda *_: False)
    assert os.listdir(tmp_path) == []


def test_the_model_is_whole_after_a_cancel(plate):
    model = paver.Model(plate)
    wanted = paver.mesh(plate, size=20).report["checksum"]
    with pytest.raises(paver.Cancelled):
        paver.mesh(model, size=20, progress=lambda *_: False)
    assert paver.mesh(model, size=20).report["checksum"] == wanted


def test_other_threads_run_on(plate):
    ticks, stop = [], threading.Event()

    def tick():
        while not stop.is_set():
            ticks.append(None)
            time.sleep(0.001)
    thread = threading.Thread(target=tick)
    thread.start()
    before = len(ticks)
    paver.mesh(plate, size=1.5)
    during = len(ticks) - before
    stop.set()
    thread.join()
    assert during > 5, "the interpreter was free"


def test_many_runs_at_once_give_what_one_gives(example):
    models = [example(name) for name in ("box.step", "conesphere.step", "wing.step")]
    wanted = {m: paver.mesh(m, size=15).report["checksum"] for m in models}
    shared = paver.Model(models[1])
    found = []

    def work(i):
        model = models[i % 3]
        source = shared if model == models[1] and i > 3 else model
        result = paver.mesh(source, size=15, progress=lambda *_: None)
        found.append(result.report["checksum"] == wanted[model] and len(result.tessellate(2).triangles) > 0)
    threads = [threading.Thread(target=work, args=(i,)) for i in range(9)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [True] * 9


def run_script(script, *arguments):
    return subprocess.run([sys.executable, "-c", f"import sys; sys.path.insert(0, {BINDINGS!r})\n{script}", *arguments],
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=120)


def test_control_c_ends_a_run(plate):
    done = run_script("""
import os, paver, signal, threading
threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    paver.mesh(sys.argv[1], size=0.1, max_elements=100_000_000)
except KeyboardInterrupt:
    print("stopped", len(paver.mesh(sys.argv[1], size=20).quads) > 0)
""", plate)
    assert (done.returncode, done.stdout, done.stderr) == (0, "stopped True\n", "")


def test_the_interpreter_may_go_while_a_daemon_works(plate):
    done = run_script("""
import paver, threading
started = threading.Event()
def work():
    try:
        paver.mesh(sys.argv[1], size=0.1, max_elements=100_000_000, progress=lambda *_: started.set())
    except paver.Cancelled:
        pass
threading.Thread(target=work, daemon=True).start()
started.wait()
print("bye")
""", plate)
    assert (done.returncode, done.stdout) == (0, "bye\n"), done.stderr
