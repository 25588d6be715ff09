#!/usr/bin/python3
"""Makes a wheel of a build folder: the Python package, the programs, and all libraries they need but the base system's.

    scripts/wheel.py BUILD-FOLDER DESTINATION     scripts/package wheel builds first and then runs this

What lies in the wheel: paver/ (the package, the compiled module, programs, readers of STEP and IGES), paver.libs/
(libraries of other packages, under names of their own so that they never stand in for a host's), licences. Of Open MPI,
which must be one with its mpirun, nothing comes along: paver-worker takes the machine's.
"""
import hashlib
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile

import elf

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
BASE = re.compile(r"(ld-linux.*|lib(c|m|dl|pthread|rt|util|stdc\+\+|gcc_s))\.so\.\d+$")  # every Python has these around
OF_THE_MACHINE = re.compile(r"lib(mpi|open-rte|open-pal)\.so\.\d+$")
COMPILED_IN = ("nlohmann-json3-dev", "libcli11-dev", "pybind11-dev")  # libraries that are headers alone
COMMON_LICENCES = "/usr/share/common-licenses"

METADATA = """Metadata-Version: 2.1
Name: paver
Version: {version}
Summary: Curved quadrilateral surface meshes of CAD models, by paving
License: LGPL-2.1-or-later
Requires-Python: >={python}
Requires-Dist: {numpy}

Surface meshes of curved quadrilaterals for Method-of-Moments solvers: the command line `paver` (or `python -m paver`) and
the module `paver`. OpenCASCADE and what else it needs come along, each under its own licence (dist-info/licenses).
Runs in several processes need Open MPI on the machine.
"""
WHEEL = """Wheel-Version: 1.0
Generator: scripts/wheel.py
Root-Is-Purelib: false
Tag: {tag}
"""
ENTRY_POINTS = """[console_scripts]
paver = _paver_command:run
"""
COMMAND = """\"\"\"The command paver: python -m paver. No part of the package, which it would load with NumPy.\"\"\"
import os
import sys


def run():
    os.execv(sys.executable, [sys.executable, "-P", "-m", "paver", *sys.argv[1:]])
"""
BUNDLED = """# What this wheel brings along

Unchanged but for names, search paths and the binding of symbols. Each comes from the Debian package named here; its
licence is in PACKAGE/copyright, texts that this refers to in common-licenses/. The source of each is Debian's source
package, at https://snapshot.debian.org for every version.

| file | package | source package | version |
|---|---|---|---|
"""


def fail(text):
    raise SystemExit("wheel: " + text)


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def install(build, folder):
    """The wheel's paver/ from the build folder, by its rules of installation."""
    stage = os.path.join(folder, "stage")
    elf.said("cmake", "--install", build, "--prefix", stage, "--strip")
    package = os.path.join(folder, "tree", "paver")
    shutil.copytree(os.path.join(stage, "lib", "python3", "dist-packages", "paver"), package)
    for name in os.listdir(os.path.join(stage, "lib", "paver")):
        shutil.copy2(os.path.join(stage, "lib", "paver", name), package)
    shutil.copy2(os.path.join(stage, "bin", "paver"), package)
    return package


def libraries_of(files):
    """{name: file} of all that `files` need, and what these need in turn, but the base system's and Open MPI's."""
    found, waiting = {}, list(files)
    while waiting:
        path = waiting.pop()
        places = elf.resolved(path)
        for name in elf.needed(path):
            if name in found or BASE.match(name) or OF_THE_MACHINE.match(name):
                continue
            if not places.get(name):
                fail(f"{path} needs {name}, which is not installed; run scripts/setup build.")
            found[name] = os.path.realpath(places[name])
            waiting.append(found[name])
    return found


def own_name(name, path):
    """libTKMath.so.7 as libTKMath-1a2b3c4d.so.7, by the content."""
    with open(path, "rb") as file:
        mark = hashlib.sha256(file.read()).hexdigest()[:8]
    stem, _, rest = name.partition(".so")
    return f"{stem}-{mark}.so{rest}"


def bundle(package):
    """Fills paver.libs and has everything look there. {name in the wheel: file that it was}."""
    folder = package + ".libs"
    os.makedirs(folder)
    own = [os.path.join(package, name) for name in sorted(os.listdir(package))]
    own = [path for path in own if elf.is_elf(path)]
    found = libraries_of(own)
    names = {name: own_name(name, path) for name, path in found.items()}
    for name, path in found.items():
        copy = os.path.join(folder, names[name])
        shutil.copyfile(path, copy)
        elf.relink(copy, names, ".", soname=names[name])
        elf.part_unique_symbols(copy)
    for path in own:
        elf.relink(path, names, "../paver.libs")
        elf.part_unique_symbols(path)
    return {names[name]: path for name, path in found.items()}


def package_of(path):
    """The Debian package that a file belongs to."""
    for name in (path, path.removeprefix("/usr")):
        done = subprocess.run(["dpkg-query", "-S", name], capture_output=True, text=True)
        if done.returncode == 0:
            return done.stdout.split(":")[0]
    return fail(f"{path} is of no Debian package, so its licence is not known; install that library from Debian.")


def add_licences(folder, bundled):
    shutil.copy(os.path.join(ROOT, "LICENSE"), os.path.join(folder, "LICENSE"))
    rows = [(name, package_of(path)) for name, path in sorted(bundled.items())]
    rows += [("(headers)", package) for package in COMPILED_IN]
    table = BUNDLED
    for name, package in rows:
        show = "${source:Package} | ${source:Version}\n"
        table += f"| {name} | {package} | {elf.said('dpkg-query', '-W', '-f', show, package).splitlines()[0]} |\n"
    write(os.path.join(folder, "bundled.md"), table)
    for package in sorted({package for _, package in rows}):
        source = f"/usr/share/doc/{package}/copyright"
        if not os.path.isfile(source):
            fail(f"the licence {source} is missing; install {package} with its documentation.")
        with open(source, encoding="utf-8", errors="replace") as file:
            text = file.read()
        write(os.path.join(folder, package, "copyright"), text)
        for name in set(re.findall(COMMON_LICENCES + r"/([\w.-]*\w)", text)):
            os.makedirs(os.path.join(folder, "common-licenses"), exist_ok=True)
            shutil.copy(os.path.join(COMMON_LICENCES, name), os.path.join(folder, "common-licenses", name))


def tag():
    """cp311-cp311-manylinux_2_36_x86_64: this Python, and any Linux with a C library as new as here; the libstdc++ must be, too."""
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    libc = os.confstr("CS_GNU_LIBC_VERSION").split()[1].replace(".", "_")
    return f"{python}-{python}-manylinux_{libc}_{platform.machine()}"


def numpy_wanted(build):
    """The module knows which memory layouts of NumPy it was compiled for."""
    ask = "import sys; sys.path.insert(0, sys.argv[1]); import _paver; print(_paver.knows_numpy_2)"
    knows = elf.said(sys.executable, "-c", ask, os.path.join(build, "bindings")).strip()
    return "numpy" if knows == "True" else "numpy<2"


def version_of(build):
    with open(os.path.join(build, "CMakeCache.txt"), encoding="utf-8") as file:
        return re.search(r"^CMAKE_PROJECT_VERSION:\w+=(.+)$", file.read(), re.M).group(1)


def describe(tree, build, bundled):
    version = version_of(build)
    information = os.path.join(tree, f"paver-{version}.dist-info")
    python = f"{sys.version_info.major}.{sys.version_info.minor}"
    write(os.path.join(information, "METADATA"), METADATA.format(version=version, python=python, numpy=numpy_wanted(build)))
    write(os.path.join(information, "WHEEL"), WHEEL.format(tag=tag()))
    os.makedirs(os.path.join(information, "licenses"))
    add_licences(os.path.join(information, "licenses"), bundled)
    write(os.path.join(information, "entry_points.txt"), ENTRY_POINTS)
    write(os.path.join(tree, "_paver_command.py"), COMMAND)


def main():
    if len(sys.argv) != 3 or not os.path.isfile(os.path.join(sys.argv[1], "CMakeCache.txt")):
        fail("give a build folder and the folder for the wheel (see the head of scripts/wheel.py).")
    build, destination = map(os.path.abspath, sys.argv[1:])
    os.makedirs(destination, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=".paver-", dir=destination) as folder:
        bundled = bundle(install(build, folder))
        tree = os.path.join(folder, "tree")
        describe(tree, build, bundled)
        elf.said(sys.executable, "-m", "wheel", "pack", tree, "--dest-dir", folder)
        name, = (name for name in os.listdir(folder) if name.endswith(".whl"))
        os.replace(os.path.join(folder, name), os.path.join(destination, name))
    print(os.path.join(destination, name))


if __name__ == "__main__":
    main()
