"""Runs that are started with mpirun by hand, as on a cluster: the job file, the table, the events, exit codes."""
import json
import os
import signal
import subprocess

import pytest

from processes import PATIENCE, PROGRAM, WING, WORKER, by_hand, descendants, is_alive, runs, wait_until, write_job

USAGE, INPUT, TOO_MANY = 2, 3, 5


def own_words(done):
    """What paver-worker says among the lines of mpirun."""
    return [line for line in done.stderr.splitlines() if line.startswith("paver-worker: ")]


@pytest.mark.parametrize("content, code, says", [
    (None, INPUT, "cannot be read"),
    ("{", USAGE, "damaged"),
    ('{"mesh": "a.msh"}', USAGE, "no input"),
    ('{"input": "wing.step"}', USAGE, "no mesh"),
    ('{"input": "wing.step", "mesh": 5}', USAGE, "wrong kind for 'mesh'"),
    ('{"input": "wing.step", "mesh": "a.msh", "nodes": 3}', USAGE, "unknown key 'nodes'"),
    ('{"input": "wing.step", "mesh": "a.msh", "msh_version": 3}', USAGE, "msh_version '3'"),
    ('{"input": "wing.step", "mesh": "a.msh", "options": {"size": -1}}', USAGE, "size is -1"),
    ('{"input": "wing.step", "mesh": "a.msh", "options": {"colour": 1}}', USAGE, "no option 'colour'"),
    ('{"input": "wing.step", "mesh": "a.stl", "options": {"size": 9}}', USAGE, "a.stl"),
    ('{"input": "wing.step", "mesh": "a.msh", "ascii": true, "options": {"size": 9}}', USAGE, "binary"),
    ('{"input": "wing.step", "mesh": "a.msh", "options": {"size": 9}}', INPUT, "'wing.step' does not exist"),
])
def test_a_bad_job_is_one_sentence(tmp_path, content, code, says):
    job = tmp_path / "job.json"
    if content is not None:
        job.write_text(content)
    done = by_hand(job, 3, cwd=tmp_path)
    assert done.returncode == code, done.stderr
    words = own_words(done)
    assert len(words) == 1 and says in words[0] and words[0].endswith("."), done.stderr
    assert os.listdir(tmp_path) == (["job.json"] if content is not None else [])


def test_usage():
    assert subprocess.run([WORKER], capture_output=True).returncode == USAGE
    assert subprocess.run([WORKER, "--size", "3"], capture_output=True).returncode == USAGE
    assert "mpirun" in subprocess.run([WORKER, "--help"], capture_output=True, text=True, check=True).stdout


def test_a_job_by_hand_writes_the_files_and_prints_the_table(tmp_path):
    local = ["Face1=15mm", "Edge2=8mm"]
    job = write_job(tmp_path / "job.json", input=WING, mesh="wing.vtu", report="wing.json",
                    options={"size": "25 mm", "order": 1, "local": local})
    done = by_hand(job, 2, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "edge length" in done.stdout and "ranks         2 busy for" in done.stdout
    given = [word for part in local for word in ("--local", part)]
    subprocess.run([PROGRAM, "mesh", WING, "-o", "one.vtu", "--size", "25", "--order", "1", *given],
                   cwd=tmp_path, check=True, capture_output=True)
    assert (tmp_path / "wing.vtu").read_bytes() == (tmp_path / "one.vtu").read_bytes()
    with open(tmp_path / "wing.json") as f:
        assert json.load(f)["order"] == 1
    assert sorted(os.listdir(tmp_path)) == ["job.json", "one.vtu", "wing.json", "wing.vtu"]


def test_events(tmp_path):
    job = write_job(tmp_path / "job.json", input=WING, mesh="wing.msh", events="-", options={"size": 4})
    done = by_hand(job, 3, cwd=tmp_path)
    events = [json.loads(line) for line in done.stdout.splitlines()]
    assert events[0] == {"event": "start", "ranks": 3, "threads": events[0]["threads"]}
    assert events[-1]["event"] == "done" and events[-1]["mesh"] == "wing.msh"
    assert len(events[-1]["busy_seconds"]) == 3 and min(events[-1]["busy_seconds"]) > 0
    assert events[-1]["elements"] > 5000
    progress = [event for event in events if event["event"] == "progress"]
    assert progress and all(0 <= event["percent"] <= 100 for event in progress)
    assert events == [events[0], *progress, events[-1]]

    job = write_job(tmp_path / "job.json", input=WING, mesh="no.msh", events="-",
                    options={"size": 1, "max_elements": 9})
    done = by_hand(job, 3, cwd=tmp_path)
    errors = [event for event in map(json.loads, done.stdout.splitlines()) if event["event"] == "error"]
    errors = [event for event in errors if event["code"] != "cancelled"]  # what ended rank 0, when it was not the first
    assert done.returncode == TOO_MANY and len(errors) == 1 and not own_words(done)
    assert errors[0]["code"] == "too_many_elements" and " 9" in errors[0]["sentence"]
    assert not (tmp_path / "no.msh").exists()


@pytest.mark.parametrize("ranks, how", [(2, "closed pipe"), (3, signal.SIGTERM), (5, signal.SIGINT)])
def test_a_closed_pipe_and_signals_to_mpirun_end_all_ranks(tmp_path, ranks, how):
    pipe = tmp_path / "events"
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    job = write_job(tmp_path / "job.json", input=WING, mesh=str(tmp_path / "wing.msh"), events=str(pipe),
                    options={"size": 0.3, "multilevel": "off"})
    with open(tmp_path / "log", "w") as log:
        child = subprocess.Popen(["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks), WORKER, job],
                                 stdin=subprocess.DEVNULL, stdout=log, stderr=log)
    said = b""

    def has_begun_paving():
        nonlocal said
        try:
            said += os.read(reader, 1 << 16)
        except BlockingIOError:
            pass
        return b'"paving"' in said
    try:
        assert wait_until(has_begun_paving), said
        known = [child.pid, *descendants(child.pid)]
        assert len(known) == 1 + ranks
        if how == "closed pipe":
            os.close(reader)
        else:
            child.send_signal(how)
        assert child.wait(PATIENCE) != 0
        assert wait_until(lambda: not any(map(is_alive, known)), PATIENCE)
    finally:
        child.kill()
        child.wait()
    assert sorted(os.listdir(tmp_path)) == ["events", "job.json", "log"]


def test_ranks_inside_a_run_of_mpi(tmp_path):
    command = [PROGRAM, "mesh", WING, "-o", str(tmp_path / "wing.msh"), "--size", "40", "--ranks", "2"]
    done = subprocess.run(["mpirun", "--allow-run-as-root", "-n", "1", *command], stdin=subprocess.DEVNULL,
                          capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    assert len(runs.meshfile.read(str(tmp_path / "wing.msh")).quads) > 100
