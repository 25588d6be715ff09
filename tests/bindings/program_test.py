"""python -m paver is the command line: same options, same output, same exit codes."""
import os
import signal
import subprocess
import sys

from conftest import BINDINGS


def run(command, **environment):
    return subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=120,
                          env={**os.environ, "PYTHONPATH": BINDINGS, **environment})


def module(*arguments, **environment):
    return run([sys.executable, "-m", "paver", *arguments], **environment)


def test_it_is_the_program(program, box, tmp_path):
    out = tmp_path / "box.msh"
    for arguments, code in ((["--version"], 0), (["mesh", "--help"], 0), ([], 2), (["mesh", "nowhere.step", "--size", "5"], 2),
                            (["mesh", box, "--size", "5", "-o", str(out), "--quiet"], 0)):
        own, ours = run([program, *arguments]), module(*arguments)
        assert (ours.returncode, ours.stdout, ours.stderr) == (own.returncode, own.stdout, own.stderr)
        assert ours.returncode == code, ours.stderr
    assert out.stat().st_size > 0


def test_it_needs_no_numpy_and_no_module(tmp_path):
    (tmp_path / "numpy.py").write_text("raise ImportError('none here')\n")
    path = os.pathsep.join((str(tmp_path), BINDINGS))
    assert module("--version", PYTHONPATH=path).returncode == 0
    loaded = run([sys.executable, "-c", "import paver"], PYTHONPATH=path)
    assert loaded.stderr.splitlines()[-1] == (f"ImportError: Paver needs NumPy, which {sys.executable} does not have; "
                                              "install it (package python3-numpy, or pip install numpy).")


def test_a_missing_program_says_what_to_run(tmp_path):
    done = module("--version", PAVER_BUILD=str(tmp_path))
    assert done.returncode == 1 and done.stderr.count("\n") == 1
    assert "does not start (No such file or directory); run scripts/build paver in " in done.stderr


def test_ctrl_c_reaches_it(example, tmp_path):
    command = [sys.executable, "-m", "paver", "mesh", example("wing.step"), "--size", "0.3", "--multilevel", "off",
               "-o", str(tmp_path / "wing.msh")]
    child = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                             env={**os.environ, "PYTHONPATH": BINDINGS})
    assert child.stdout.readline(), "the program says its first stage"
    child.send_signal(signal.SIGINT)
    child.communicate(timeout=60)
    assert child.returncode == 130 and not os.path.exists(tmp_path / "wing.msh")
