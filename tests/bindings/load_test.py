"""Finding the compiled module: missing, stale or foreign builds say in one sentence what to run. No MPI comes along."""
import os
import shutil
import subprocess
import sys

import pytest

import paver
from conftest import BINDINGS, ROOT
from paver import _paver


@pytest.fixture
def checkout(tmp_path):
    """A copy of the package in a folder like a checkout, without a build."""
    shutil.copytree(os.path.join(BINDINGS, "paver"), tmp_path / "bindings" / "paver",
                    ignore=shutil.ignore_patterns("__pycache__"))
    (tmp_path / "core" / "src" / "cli").mkdir(parents=True)
    (tmp_path / "core" / "src" / "a.cpp").write_text("")
    return tmp_path


def load(checkout, before="", **environment):
    script = before + f"import sys; sys.path.insert(0, {str(checkout / 'bindings')!r}); import paver; print(paver.__version__)"
    clean = {k: v for k, v in os.environ.items() if k != "PAVER_BUILD"}
    return subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60,
                          env={**clean, "PYTHONDONTWRITEBYTECODE": "1", **environment})


def put_build(checkout, name=None):
    folder = checkout / "build" / "bindings"
    folder.mkdir(parents=True)
    return shutil.copy(_paver.__file__, folder / (name or os.path.basename(_paver.__file__)))


def test_without_numpy_the_package_to_install_is_named(checkout):
    put_build(checkout)
    bare = "import sys; sys.path[:] = [p for p in sys.path if not p.endswith('-packages')]; "
    done = load(checkout, bare)
    assert done.returncode == 1
    assert done.stderr.splitlines()[-1] == (f"ImportError: Paver needs NumPy, which {sys.executable} does not have; "
                                            "install it (package python3-numpy, or pip install numpy).")


def test_what_numpy_causes_can_be_told_from_the_rest(checkout, tmp_path):
    put_build(checkout)
    (tmp_path / "numpy.py").write_text("__version__ = '2.0.1'\n")
    name = "import sys; sys.excepthook = lambda kind, error, trace: print('name:', error.name); "
    if not _paver.knows_numpy_2:
        assert load(checkout, name, PYTHONPATH=str(tmp_path)).stdout.strip() == "name: numpy"
    bare = "sys.path[:] = [p for p in sys.path if not p.endswith('-packages')]; "
    assert load(checkout, name + bare).stdout.strip() == "name: numpy"
    shutil.rmtree(checkout / "build")
    assert load(checkout, name).stdout.strip() == "name: None"


def test_a_missing_build_says_what_to_run(checkout):
    done = load(checkout)
    assert done.returncode == 1
    assert done.stderr.splitlines()[-1] == ("ImportError: Paver's compiled module is missing; run scripts/build "
                                            f"paver_python in {checkout}.")


def test_a_build_for_another_python_says_so(checkout):
    put_build(checkout, "_paver.cpython-27-x86_64-linux-gnu.so")
    message = load(checkout).stderr.splitlines()[-1]
    assert "is for another Python than" in message and "scripts/build paver_python" in message


def test_a_build_that_does_not_load_says_so(checkout):
    with open(put_build(checkout), "wb") as broken:
        broken.write(b"no library")
    message = load(checkout).stderr.splitlines()[-1]
    assert message.startswith("ImportError: Paver's compiled module does not load (") and "scripts/setup" in message


def test_a_stale_build_warns_and_a_fresh_one_does_not(checkout):
    built = put_build(checkout)
    stamp = os.stat(built).st_mtime
    os.utime(checkout / "core" / "src" / "a.cpp", (stamp - 5, stamp - 5))
    fresh = load(checkout)
    assert (fresh.stdout.strip(), fresh.stderr) == (paver.__version__, "")
    (checkout / "core" / "src" / "cli" / "main.cpp").write_text("")
    os.utime(checkout / "core" / "src" / "cli" / "main.cpp", (stamp + 5, stamp + 5))
    assert load(checkout).stderr == "", "the command line is no part of the module"
    os.utime(checkout / "core" / "src" / "a.cpp", (stamp + 5, stamp + 5))
    stale = load(checkout)
    assert stale.stdout.strip() == paver.__version__, "it works all the same"
    assert ("RuntimeWarning: Paver's compiled module is older than its sources; run scripts/build paver_python in "
            f"{checkout}.") in stale.stderr


def put_installed(folder, version=None):
    """A package elsewhere, as pip or the system installs it; its compiled module says that it has the version."""
    package = folder / "site" / "paver"
    package.mkdir(parents=True)
    (package / "__init__.py").write_text("raise ImportError('the wrong package')")
    path = package / os.path.basename(_paver.__file__)
    with open(_paver.__file__, "rb") as built:
        path.write_bytes(built.read().replace(b"module, version " + paver.__version__.encode(),
                                              b"module, version " + (version or paver.__version__).encode()))
    return str(package.parent)


def test_the_compiled_part_of_an_installed_package_is_used(checkout, tmp_path):
    done = load(checkout, PYTHONPATH=put_installed(tmp_path))
    assert (done.stdout.strip(), done.stderr) == (paver.__version__, "")


def test_of_two_compiled_parts_the_one_of_the_same_version_is_used(checkout, tmp_path):
    (checkout / "package.xml").write_text(f"<version>{paver.__version__}</version>")
    os.makedirs(checkout / "build")
    os.rename(os.path.join(put_installed(tmp_path / "old", "9.9.9"), "paver"), checkout / "build" / "bindings")
    done = load(checkout, PYTHONPATH=put_installed(tmp_path))
    assert (done.stdout.strip(), done.stderr) == (paver.__version__, "")


def test_a_compiled_part_of_another_version_is_told_with_both(checkout, tmp_path):
    (checkout / "package.xml").write_text(f"<version>{paver.__version__}</version>")
    message = load(checkout, PYTHONPATH=put_installed(tmp_path, "9.9.9")).stderr.splitlines()[-1]
    assert "has version 9.9.9, but its package" in message and f"has version {paver.__version__}; run" in message


def test_one_that_does_not_load_keeps_no_other_back(checkout, tmp_path):
    with open(put_build(checkout), "wb") as broken:
        broken.write(b"no library")
    assert load(checkout, PYTHONPATH=put_installed(tmp_path)).stdout.strip() == paver.__version__


def test_another_build_folder_may_be_named(checkout):
    put_build(checkout)
    os.rename(checkout / "build", checkout / "elsewhere")
    assert load(checkout).returncode == 1
    assert load(checkout, PAVER_BUILD=str(checkout / "elsewhere")).returncode == 0


def test_no_mpi_is_loaded():
    needed = subprocess.run(["ldd", _paver.__file__], capture_output=True, text=True, check=True).stdout
    assert "libTKernel" in needed and "mpi" not in needed.lower()


def test_only_its_own_symbol_is_visible():
    symbols = subprocess.run(["nm", "-D", "--defined-only", _paver.__file__], capture_output=True, text=True).stdout
    names = [line.split()[-1] for line in symbols.splitlines() if " T " in line]
    assert names == ["PyInit__paver"]


def test_freecad_finds_the_package_through_init_py(tmp_path):
    os.symlink(ROOT, tmp_path / "Paver")
    script = f"""
import sys, types
sys.path.insert(0, {str(tmp_path / 'Paver')!r})
types_of_files = lambda *of: None
freecad = types.SimpleNamespace(__unit_test__=[], addImportType=types_of_files, addExportType=types_of_files,
                                getUserAppDataDir=lambda: {str(tmp_path)!r})
sys.modules["FreeCAD"] = freecad
exec(compile(open({os.path.join(ROOT, 'Init.py')!r}).read(), "Init.py", "exec"), {{"FreeCAD": freecad}})
assert sys.path[2] == {str(tmp_path / "Paver" / "binary")!r}
import paver
print(paver.__file__)
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60)
    assert done.stdout.strip() == str(tmp_path / "Paver" / "bindings" / "paver" / "__init__.py"), done.stderr
