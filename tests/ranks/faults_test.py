"""What goes wrong in a run of several ranks, done: cancel, killed processes, no memory, a full disk, a parent that is
gone. Each time one sentence and its exit code, and nothing is left: no file, no process, no temporary folder."""
import os
import resource
import shutil
import signal
import subprocess

import pytest

from processes import PATIENCE, PROGRAM, Run, WING, WORKER, wait_until

OTHER, USAGE, INPUT, TOO_MANY, OUTPUT, CANCELLED = 1, 2, 3, 5, 6, 130
LONG = ("--size", "0.4", "--multilevel", "off")  # more work than anyone waits for who stops it at once


@pytest.fixture
def start(tmp_path):
    """start(ranks, option...) starts a run; whatever is left of it ends with the test."""
    started = []

    def starter(ranks, *options, **more):
        started.append(Run(tmp_path, ranks, *options, **more))
        return started[-1]
    yield starter
    for run in started:
        run.close()


def serial_sentence(tmp_path, *options, model=WING):
    """(exit code, sentence) of one process alone, which several must repeat."""
    done = subprocess.run([PROGRAM, "mesh", model, "-o", str(tmp_path / "serial.msh"), *map(str, options)],
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60)
    return done.returncode, done.stderr.strip()


@pytest.mark.parametrize("ranks, number", [(2, signal.SIGINT), (3, signal.SIGTERM), (5, signal.SIGINT)])
def test_a_signal_to_the_parent_ends_all_ranks(start, ranks, number):
    run = start(ranks, *LONG)
    run.wait_for_paving()
    run.child.send_signal(number)
    assert run.wait(PATIENCE) == CANCELLED
    run.expect_nothing_left()
    assert "Cancelled" in run.sentence()


def test_too_few_open_files_are_told_at_once(tmp_path):
    limit = lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (33, 33))  # noqa: E731
    done = subprocess.run([PROGRAM, "mesh", WING, "-o", str(tmp_path / "out.msh"), "--size", "20", "--ranks", "2"],
                          stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60, preexec_fn=limit)
    assert done.returncode == USAGE
    assert "takes 40 open files, and the system allows 33" in done.stderr
    assert not os.listdir(tmp_path)


@pytest.mark.parametrize("ranks", [2, 5])
def test_a_parent_that_vanishes_takes_all_ranks_with_it(start, ranks):
    run = start(ranks, *LONG)
    run.wait_for_paving()
    run.child.kill()
    run.wait()
    run.expect_nothing_left()


def test_a_parent_that_vanishes_at_once_leaves_nothing(start):
    run = start(3, *LONG)
    assert wait_until(run.processes)
    run.child.kill()
    run.wait()
    run.expect_nothing_left()


@pytest.mark.parametrize("ranks, victim", [(2, 0), (3, 2), (5, 1)])
def test_a_killed_rank_is_named_and_ends_the_others(start, ranks, victim):
    run = start(ranks, *LONG)
    run.wait_for_paving()
    os.kill(run.rank(victim), signal.SIGKILL)
    assert run.wait(PATIENCE) == OTHER
    run.expect_nothing_left()
    assert f"Rank {victim} of {ranks} was ended by signal 9" in run.sentence()


@pytest.mark.parametrize("who", ["mpirun", "watcher"])
def test_a_killed_helper_ends_the_ranks(start, who):
    run = start(3, *LONG)
    run.wait_for_paving()
    os.kill(run.mpirun() if who == "mpirun" else run.watcher(), signal.SIGKILL)
    assert run.wait(PATIENCE) == OTHER
    run.expect_nothing_left()
    assert "signal 9" in run.sentence()


@pytest.mark.parametrize("ranks, victim", [(2, 1), (3, 0)])
def test_a_rank_out_of_memory_says_so(start, ranks, victim):
    run = start(ranks, *LONG)
    run.wait_for_paving()
    pid = run.rank(victim)
    with open(f"/proc/{pid}/statm") as f:
        now = int(f.read().split()[0]) * os.sysconf("SC_PAGE_SIZE")
    resource.prlimit(pid, resource.RLIMIT_AS, (now, now))
    assert run.wait() == OTHER
    run.expect_nothing_left()
    assert "emory" in run.sentence()


SMALL_DISK = 'mount -t tmpfs -o size=100k none "$0" && exec "$@"'


def test_a_full_disk_is_said_and_leaves_no_file(start, tmp_path):
    disk = tmp_path / "out"
    disk.mkdir()
    new_space = ["unshare", "--mount"] if os.geteuid() == 0 else ["unshare", "--mount", "--map-root-user"]
    if subprocess.run([*new_space, "sh", "-c", SMALL_DISK, str(disk), "true"], capture_output=True).returncode:
        pytest.skip("no file system can be mounted here")
    check = f'"$@"; code=$?; ls -A "{disk}" >&2; exit $code'
    run = start(3, "--size", "5", program=[*new_space, "sh", "-c", SMALL_DISK, str(disk), "sh", "-c", check, "-", PROGRAM])
    assert run.wait() == OUTPUT
    run.expect_nothing_left()
    assert "No space left".lower() in run.sentence().lower() and "wing.msh" in run.sentence()


@pytest.mark.parametrize("ranks, settings", [(1, {}), (3, {}), (5, {}), (2, {"OMPI_MCA_hwloc_base_binding_policy": "core"}),
                                             (3, {"OMPI_MCA_rmaps_base_mapping_policy": "slot"})])
def test_a_finished_run_leaves_its_file_alone(start, ranks, settings):
    run = start(ranks, "--size", "8", **settings)
    assert wait_until(lambda: run.child.poll() is not None or len(run.workers()) == ranks)
    assert run.wait() == 0, run.said("stderr")
    run.expect_nothing_left(["wing.msh"])
    assert not run.said("stderr")


def test_no_mpirun_and_no_worker_are_bad_usage(start, tmp_path):
    run = start(2, "--size", "40", PATH=str(tmp_path))
    assert run.wait() == USAGE
    assert "--ranks is 2, but there is no mpirun" in run.sentence()
    run.expect_nothing_left()
    run = start(2, "--size", "40", PAVER_WORKER="/no/such/worker")
    assert run.wait() == USAGE
    assert "'/no/such/worker'" in run.sentence()
    lone = tmp_path / "paver"  # away from the programs that belong to it
    shutil.copy(PROGRAM, lone)
    shutil.copy(WORKER, tmp_path / "paver-worker")
    run = start(2, "--size", "40", program=[str(lone)])
    assert run.wait() == USAGE
    assert "no program paver-watch" in run.sentence()
    run = start(-1, "--size", "40")
    assert run.wait() == USAGE
    assert "--ranks is -1" in run.sentence()
    run.expect_nothing_left()


@pytest.mark.parametrize("broken, says", [("exit 3", "exit code 3"), ("echo no route to host; exit 1", "no route to host"),
                                          ("exit 0", "exit code 0")])
def test_an_mpirun_that_fails_is_said(start, tmp_path, broken, says):
    script = tmp_path / "mpirun"
    script.write_text(f"#!/bin/sh\n{broken}\n")
    script.chmod(0o755)
    run = start(2, "--size", "40", PAVER_MPIRUN=str(script))
    assert run.wait() == OTHER
    assert says in run.sentence()
    run.expect_nothing_left()


def test_errors_of_the_input_are_those_of_one_process(start, tmp_path):
    damaged = tmp_path / "damaged.step"
    with open(WING, "rb") as f:
        damaged.write_bytes(f.read()[:3000])
    for model, code in (("nowhere.step", INPUT), (str(damaged), INPUT), (str(tmp_path), INPUT)):
        run = start(3, "--size", "40", model=model)
        assert (run.wait(), run.sentence()) == serial_sentence(tmp_path, "--size", "40", model=model)
        assert run.child.returncode == code
        run.expect_nothing_left()


def test_what_all_ranks_find_is_said_once(start, tmp_path):
    limits = ("--size", "1", "--max-elements", "10")
    run = start(5, *limits)
    assert run.wait() == TOO_MANY
    assert run.sentence() == serial_sentence(tmp_path, *limits)[1]
    run.expect_nothing_left()
