"""The wheel, installed far from the checkout: its program and module mesh as the checkout's own program does, and nothing
but the base system is used from outside of it."""
import base64
import csv
import glob
import hashlib
import io
import os
import re
import shutil
import subprocess
import sys
import zipfile

import pytest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.append(os.path.join(ROOT, "tests", "support"))
import built_wheel  # noqa: E402
import freecad_program  # noqa: E402
from built_wheel import BUILD  # noqa: E402

PROGRAM = os.environ.get("PAVER_PROGRAM") or os.path.join(BUILD, "core", "paver")
WING = os.path.join(ROOT, "Resources", "examples", "wing.step")
SIZE = "20"
BASE = re.compile(r"(ld-linux.*|linux-vdso|lib(c|m|dl|pthread|rt|util|stdc\+\+|gcc_s))\.so(\.\d+)?$")
OF_OURS = re.compile(r"lib(TK|tbb|fmt)")  # what the wheel must take from itself alone
BOUND = re.compile(r"binding file (/.+?) \[\d+\] to (/.+?) \[\d+\]: \w+ symbol `(\w+)'")


def run(*command, **environment):
    """CompletedProcess with nothing in the environment but what is given."""
    return subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=300, env=environment)


def content(path):
    with open(path, "rb") as file:
        return file.read()


def needed(path):
    said = run("readelf", "-d", path, PATH="/usr/bin:/bin").stdout
    return re.findall(r"\(NEEDED\).*\[(.*)\]", said)


class Place:
    """A virtual environment with the wheel."""

    def __init__(self, folder, wheel, *options):
        self.folder = str(folder)
        made = run(sys.executable, "-m", "venv", *options, self.folder)
        assert made.returncode == 0, made.stderr
        done = self.python("-m", "pip", "install", "--no-index", *([] if options else ["--no-deps"]), wheel)
        assert done.returncode == 0, done.stdout + done.stderr
        self.packages, = glob.glob(os.path.join(self.folder, "lib", "python*", "site-packages"))

    def python(self, *arguments, **environment):
        return run(os.path.join(self.folder, "bin", "python"), *arguments, **environment)

    def files(self):
        """Programs and libraries of the wheel."""
        listed = glob.glob(os.path.join(self.packages, "paver", "*")) + glob.glob(os.path.join(self.packages, "paver.libs", "*"))
        return [path for path in listed if os.path.isfile(path) and content(path).startswith(b"\x7fELF")]


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    return built_wheel.make(tmp_path_factory.mktemp("ein Rad für alle"))


@pytest.fixture(scope="module")
def bare(wheel, tmp_path_factory):
    """Without NumPy."""
    return Place(tmp_path_factory.mktemp("ohne zusätzliche Pakete") / "venv", wheel)


@pytest.fixture(scope="module")
def place(wheel, tmp_path_factory):
    """With the system's NumPy."""
    return Place(tmp_path_factory.mktemp("mit zusätzlichen Paketen") / "venv", wheel, "--system-site-packages")


@pytest.fixture(scope="module")
def expected(tmp_path_factory):
    """The mesh that the checkout's own program makes."""
    out = str(tmp_path_factory.mktemp("expected") / "wing.msh")
    subprocess.run([PROGRAM, "mesh", WING, "--size", SIZE, "-o", out, "--quiet"], check=True, timeout=300)
    return content(out)


def mesh(out, model=WING):
    """Lines of Python that mesh with the module."""
    return f"import paver\npaver.mesh({str(model)!r}, size={SIZE}).write({str(out)!r})\n"


def test_the_record_has_every_file(wheel):
    with zipfile.ZipFile(wheel) as archive:
        record, = (name for name in archive.namelist() if name.endswith("dist-info/RECORD"))
        rows = list(csv.reader(io.StringIO(archive.read(record).decode())))
        assert sorted(row[0] for row in rows) == sorted(archive.namelist())
        for name, mark, size in rows:
            if name != record:
                data = archive.read(name)
                digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
                assert (mark, int(size)) == ("sha256=" + digest, len(data)), name


def test_licences_come_along(wheel):
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        folder = os.path.dirname(next(n for n in names if n.endswith("/WHEEL"))) + "/licenses/"
        table = archive.read(folder + "bundled.md").decode()
        rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in table.splitlines() if line.startswith("| ")]
        files = {row[0]: row[1] for row in rows[1:]}
        bundled = [os.path.basename(n) for n in names if n.startswith("paver.libs/")]
        assert len(bundled) > 10 and set(bundled) <= set(files)
        for row in rows[1:]:
            assert archive.read(f"{folder}{row[1]}/copyright").strip(), row
        assert {folder + "LICENSE", folder + "common-licenses/LGPL-2.1"} <= set(names)


def test_only_the_base_system_is_used_from_outside(bare):
    for path in bare.files():
        for name in needed(path):
            beside = os.path.exists(os.path.join(bare.packages, "paver.libs", name))
            of_machine = path.endswith("paver-worker") and name.startswith("libmpi.so")
            assert beside or BASE.match(name) or of_machine, f"{path} needs {name}"
        found = run("ldd", path, PATH="/usr/bin:/bin").stdout
        for line in found.splitlines():
            name, _, where = line.strip().partition(" => ")
            if OF_OURS.match(os.path.basename(name)):
                assert where.startswith(os.path.join(os.path.realpath(bare.packages), "paver")), line


def test_no_name_is_one_of_the_systems(bare):
    for path in glob.glob(os.path.join(bare.packages, "paver.libs", "*")):
        own = re.search(r"\(SONAME\).*\[(.*)\]", run("readelf", "-d", path, PATH="/usr/bin:/bin").stdout).group(1)
        assert own == os.path.basename(path) and re.search(r"-[0-9a-f]{8}\.so", own)
        symbols = run("readelf", "-W", "--dyn-syms", path, PATH="/usr/bin:/bin").stdout
        assert " GLOBAL " in symbols and " UNIQUE " not in symbols, "a process has unique symbols once for all libraries"


@pytest.mark.parametrize("how", ["command", "module"])
def test_the_program_meshes_without_numpy(bare, expected, tmp_path, how):
    out = str(tmp_path / "wing.msh")
    arguments = ["mesh", WING, "--size", SIZE, "-o", out, "--quiet"]
    if how == "command":
        done = run(os.path.join(bare.folder, "bin", "paver"), *arguments)
    else:
        done = bare.python("-m", "paver", *arguments)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert content(out) == expected


def test_the_program_has_its_own_exit_codes(bare):
    own = run(PROGRAM, "mesh", "nowhere.step", "--size", "5", "-o", "out.msh")
    done = bare.python("-m", "paver", "mesh", "nowhere.step", "--size", "5", "-o", "out.msh")
    assert own.returncode == 3 and (done.returncode, done.stderr) == (own.returncode, own.stderr)


def test_the_module_says_that_numpy_is_missing(bare):
    done = bare.python("-c", "import paver")
    assert done.returncode == 1
    assert done.stderr.splitlines()[-1] == (f"ImportError: Paver needs NumPy, which {bare.folder}/bin/python does not have; "
                                            "install it (package python3-numpy, or pip install numpy).")


def test_another_memory_layout_of_numpy_is_refused(bare, tmp_path):
    (tmp_path / "numpy.py").write_text("__version__ = '2.0.1'\n")
    done = bare.python("-c", "import paver; print(paver._paver.knows_numpy_2)", PYTHONPATH=str(tmp_path))
    assert done.stdout.strip() == "True" or "needs NumPy 1, and this is NumPy 2.0.1" in done.stderr.splitlines()[-1]


def test_the_module_meshes(place, expected, tmp_path):
    out = tmp_path / "wing.msh"
    code = mesh(out) + "print(paver.__file__)\nprint(open('/proc/self/maps').read())\n"
    done = place.python("-c", code)
    assert done.returncode == 0, done.stderr
    assert content(out) == expected
    file, _, maps = done.stdout.partition("\n")
    assert file.startswith(place.packages)
    # TBB itself takes libtbbmalloc where the system has one, beside the wheel's own.
    loaded = {line.split(None, 5)[5] for line in maps.splitlines() if len(line.split(None, 5)) == 6}
    foreign = [p for p in loaded if OF_OURS.match(os.path.basename(p)) and not p.startswith(os.path.realpath(place.packages))]
    assert [p for p in foreign if "libtbbmalloc.so" not in p] == []


def expect_own_symbols(place, log):
    """That the wheel's files use the wheel's OpenCASCADE and TBB alone, and nobody else uses these. (fmt has its version
    in every name.)"""
    bound = set()
    for name in glob.glob(f"{log}.*"):
        with open(name, errors="replace") as file:
            bound |= set(BOUND.findall(file.read()))
    own = os.path.join(place.packages, "paver")
    assert len([b for b in bound if b[0].startswith(own) and b[1].startswith(own)]) > 1000
    asked = "_ZTI18Standard_Transient"  # looked for, to find out whether there is another OpenCASCADE
    foreign = [b for b in bound if b[0].startswith(own) and not b[1].startswith(own) and b[2] != asked]
    assert [b for b in foreign if re.match(r"lib(TK|tbb\.)", os.path.basename(b[1]))] == []
    assert [b for b in bound if not b[0].startswith(own) and b[1].startswith(own) and not b[2].startswith("PyInit")] == []


@pytest.mark.parametrize("user, start", [("libpaver_step.so", "libTK"), ("paver", "libtbb")])
def test_others_that_all_see_are_left_alone(place, expected, tmp_path, user, start):
    libraries = [name for name in needed(os.path.join(BUILD, "core", user)) if name.startswith(start)]
    assert libraries
    out, log = tmp_path / "wing.msh", tmp_path / "symbols"
    code = f"import ctypes\nfor n in {libraries!r}: ctypes.CDLL(n, mode=ctypes.RTLD_GLOBAL)\n" + mesh(out)
    done = place.python("-c", code, LD_DEBUG="bindings", LD_DEBUG_OUTPUT=str(log))
    assert done.returncode == 0, done.stderr
    assert content(out) == expected
    expect_own_symbols(place, log)


def test_inside_freecad(place, expected, tmp_path):
    if not freecad_program.program():
        (pytest.fail if os.environ.get("CI") == "true" else pytest.skip)("FreeCAD is not installed")
    out, log, macro = tmp_path / "wing.msh", tmp_path / "symbols", tmp_path / "mesh.FCMacro"
    macro.write_text(f"import sys\nsys.path.insert(0, {place.packages!r})\nimport Part\nPart.read({WING!r})\n{mesh(out)}"
                     "assert paver.mesh(Part.makeSphere(30), size=5).quads.size > 0\n"
                     f"assert paver.__file__.startswith({place.packages!r})\nsys.exit(5)\n")
    home = freecad_program.profile(tmp_path / "profile")
    shutil.rmtree(os.path.join(home, "Mod"))  # not the checkout's module
    done = freecad_program.run([str(macro)], home, LD_DEBUG="bindings", LD_DEBUG_OUTPUT=str(log))
    assert done.returncode == 5, (done.stdout + done.stderr)[-3000:]
    assert content(out) == expected
    expect_own_symbols(place, log)


needs_mpi = pytest.mark.skipif(not os.path.exists(os.path.join(BUILD, "core", "paver-worker")),
                               reason="Paver was built without MPI")


@needs_mpi
def test_several_ranks_by_the_machines_open_mpi(bare, expected, tmp_path):
    out = str(tmp_path / "wing.msh")
    done = run(os.path.join(bare.folder, "bin", "paver"), "mesh", WING, "--size", SIZE, "-o", out, "--quiet", "--ranks", "2",
               PATH="/usr/bin:/bin", HOME=str(tmp_path))
    assert (done.returncode, done.stderr) == (0, "")
    assert content(out) == expected


@needs_mpi
def test_without_open_mpi_one_sentence_says_what_to_install(bare, tmp_path):
    command = [os.path.join(bare.packages, "paver", "paver"), "mesh", WING, "--size", SIZE, "-o", str(tmp_path / "out.msh"),
               "--ranks", "2", "--quiet"]
    done = run(*command, PATH="/nowhere")
    assert done.returncode == 2 and "openmpi-bin" in done.stderr and done.stderr.count("\n") == 1
    worker = str(tmp_path / "paver-worker")  # as on a machine with an mpirun that is not Open MPI's
    shutil.copy(os.path.join(bare.packages, "paver", "paver-worker"), worker)
    name, = (n for n in needed(worker) if n.startswith("libmpi"))
    subprocess.run(["patchelf", "--set-rpath", os.path.join(bare.packages, "paver.libs"), worker], check=True)
    subprocess.run(["patchelf", "--replace-needed", name, "libmpi-none.so.40", worker], check=True)
    done = run(*command, PATH="/usr/bin:/bin", HOME=str(tmp_path), PAVER_WORKER=worker)
    assert done.returncode == 2 and done.stderr.count("\n") == 1, done.stderr
    assert "without the library libmpi-none.so.40; install Open MPI (package openmpi-bin)" in done.stderr
    assert not os.path.exists(tmp_path / "out.msh")
