"""Binaries of the core: wheels, as scripts/package makes them, unpacked into a folder of the user's FreeCAD data."""
import glob
import importlib.machinery
import lzma
import os
import re
import shutil
import struct
import subprocess
import sys
import sysconfig
import tempfile
import zipfile
import zlib

from paver_wb import core
from paver_wb.processes import child_process

NAMES = "paver-*.whl"
MODULE = re.compile(r"paver/_paver(\.[^/]*\.?(?:so|pyd))")
TRY_OUT = 60  # seconds
UNPACKING = "unpacking-"  # how folders begin that are not in their place yet
# What a wheel raises that is damaged, cut off, encrypted or packed in a way that Python does not know.
UNREADABLE = (OSError, EOFError, RuntimeError, UnicodeError, struct.error, lzma.LZMAError, zlib.error,
              zipfile.BadZipFile)


def loader():
    """The module that finds the compiled part; it is there without the core."""
    if "paver._load" not in sys.modules:
        core.problem()  # loads it
    return sys.modules["paver._load"]


def checkout():
    return loader().CHECKOUT


def own_version():
    return loader().own_version()


def said(error):
    return str(error) or type(error).__name__


def compiled(path):
    """Endings of the compiled modules in a wheel, and the content of the one for this Python, None without it."""
    with zipfile.ZipFile(path) as wheel:
        names = {found.group(1): found.group() for found in map(MODULE.fullmatch, wheel.namelist()) if found}
        mine = [ending for ending in importlib.machinery.EXTENSION_SUFFIXES if ending in names]
        return sorted(names), wheel.read(names[mine[0]]) if mine else None


def check(path):
    """ValueError, one sentence, where a file is no wheel of the add-on's version for the Python that runs this."""
    wanted = f"choose a file paver-{own_version()}-*.whl"
    name = os.path.basename(path)
    try:
        endings, module = compiled(path)
    except UNREADABLE as error:
        raise ValueError(f"{path} cannot be read as a wheel ({said(error)}); {wanted} that is whole.") from None
    if not endings:
        raise ValueError(f"{name} has no compiled module of Paver in it; {wanted}.")
    if module is None:
        raise ValueError(f"{name} is for another Python or another machine ({', '.join(endings)}) than this FreeCAD "
                         f"has ({sysconfig.get_config_var('EXT_SUFFIX')}); {wanted} for that one.")
    version = loader().marked_version(module)
    if version != own_version():
        raise ValueError(f"{name} has version {version or 'unknown'} of Paver's core, but the add-on has version "
                         f"{own_version()}; {wanted}.")


def places():
    """Folders of FreeCAD's, and of the add-on, where a wheel may have been put."""
    import FreeCAD
    data = FreeCAD.getUserAppDataDir()
    return [os.path.join(data, "Paver"), data, os.path.join(data, "Mod"), checkout(), os.path.join(checkout(), "dist")]


def found():
    """The path of a wheel that fits, in places(); None without one."""
    for path in (path for place in places() for path in sorted(glob.glob(os.path.join(glob.escape(place), NAMES)))):
        try:
            check(path)
        except ValueError:
            continue
        return path
    return None


def unpack(path, folder):
    """Unpacks a wheel with the permissions it has; programs lose theirs otherwise."""
    with zipfile.ZipFile(path) as wheel:
        for info in wheel.infolist():
            made, mode = wheel.extract(info, folder), info.external_attr >> 16
            if mode & 0o111 and not info.is_dir():
                os.chmod(made, 0o755)


def try_out(folder, name):
    """ValueError where the package in a folder does not load on this machine: libraries may be missing or too old."""
    try:
        program = child_process.interpreter()
    except child_process.ChildDied:
        return  # FreeCAD itself will tell
    done = subprocess.run([program, "-c", "import paver"], capture_output=True, text=True, stdin=subprocess.DEVNULL,
                          timeout=TRY_OUT, cwd=folder, env={**os.environ, "PYTHONPATH": folder})
    if done.returncode:
        last = (done.stderr.strip().splitlines() or [f"exit code {done.returncode}"])[-1]
        if "needs NumPy" in last:  # it says itself what to do
            raise ValueError(f"{name} does not load on this machine: {last.partition(': ')[2]}")
        raise ValueError(f"{name} does not load on this machine ({last}); build Paver here, or choose a file made for "
                         "it.")


def put(made, folder):
    """Puts an unpacked folder in the place of the one of before, if there is one, which stays where that fails."""
    before = made + "-before"
    is_there = os.path.isdir(folder)
    if is_there:
        os.rename(folder, before)
    try:
        os.rename(made, folder)
    except OSError:
        if is_there:
            os.rename(before, folder)
        raise
    shutil.rmtree(before, ignore_errors=True)


def remove_remains(above):
    """Of a program that ended while it unpacked."""
    for folder in glob.glob(os.path.join(glob.escape(above), UNPACKING + "*")):
        shutil.rmtree(folder, ignore_errors=True)


def install(path):
    """Unpacks a wheel for core.load() to find, whole or not at all. ValueError, one sentence, where it does not fit."""
    check(path)
    folder = core.binary_folder()
    above = os.path.dirname(folder)
    made = None
    try:
        os.makedirs(above, exist_ok=True)
        remove_remains(above)
        made = tempfile.mkdtemp(prefix=UNPACKING, dir=above)
        unpack(path, made)
        try_out(made, os.path.basename(path))
        put(made, folder)
    except (*UNREADABLE, subprocess.TimeoutExpired) as error:
        raise ValueError(f"{path} cannot be unpacked into {above} ({said(error)}); check the file and the space "
                         "there.") from None
    finally:
        if made:
            shutil.rmtree(made, ignore_errors=True)
