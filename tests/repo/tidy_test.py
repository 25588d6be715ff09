"""The checks of .clang-tidy hold in core/src, except brep/, formats/ and topology/, whose OpenCASCADE headers take
too long.

What clang 14 cannot compile of C++20 is no fault: gcc is the compiler. Files without complaint are remembered in the
folder $PAVER_TIDY_CACHE (build/tidy), by their content and that of the headers they include, and not looked at again.

    tidy_test.py [BUILD-FOLDER]     the folder holds compile_commands.json
"""
from concurrent.futures import ThreadPoolExecutor
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../support"))
import repo  # noqa: E402


def included(name):
    """The project's headers that a file includes, and those that these include."""
    found, left = set(), [name]
    while left:
        for header in re.findall(r'^#include "(.+)"', repo.text(left.pop()), re.M):
            here = next((h for h in (f"core/src/{header}", f"core/include/{header}")
                         if os.path.exists(os.path.join(repo.ROOT, h))), None)
            if here and here not in found:
                found.add(here)
                left.append(here)
    return sorted(found)


def digest(tool, name):
    """One number for all that decides what the tool says of a file."""
    total = hashlib.sha256(tool.encode())
    for part in (".clang-tidy", name, *included(name)):
        total.update(f"{part}\0{repo.text(part)}\0".encode())
    return total.hexdigest()[:32]


def check(build, name, known):
    """Lines of complaint about one source file; without any the file `known` is made."""
    if os.path.exists(known):
        os.utime(known)
        return []
    run = subprocess.run(["clang-tidy", "-p", build, "--quiet", "--extra-arg=-w", name], cwd=repo.ROOT,
                         capture_output=True, text=True, stdin=subprocess.DEVNULL)
    found = [line.replace(repo.ROOT + "/", "") for line in run.stdout.splitlines()
             if re.search(r": (warning|error): ", line)]
    found = [line for line in found if "[clang-diagnostic-error]" not in line]
    if not found and run.returncode in (0, 1):
        with open(known, "w"):
            pass
    return found


def forget(folder, days):
    """What was not asked for that long belongs to contents of the past."""
    for entry in os.scandir(folder):
        if time.time() - entry.stat().st_mtime > days * 86400:
            os.remove(entry)


def main():
    build = sys.argv[1] if len(sys.argv) > 1 else os.path.join(repo.ROOT, "build")
    commands = os.path.join(build, "compile_commands.json")
    if not shutil.which("clang-tidy") or not os.path.exists(commands):
        repo.skip("clang-tidy or compile_commands.json is missing")
    with open(commands) as f:
        compiled = {os.path.relpath(c["file"], repo.ROOT) for c in json.load(f)}
    names = sorted(n for n in compiled if n.startswith("core/src/") and n.split("/")[2] not in ("brep", "formats", "topology"))
    tool = subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True).stdout
    cache = os.environ.get("PAVER_TIDY_CACHE") or os.path.join(build, "tidy")
    os.makedirs(cache, exist_ok=True)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        faults = sorted({line for lines in pool.map(
            lambda n: check(build, n, os.path.join(cache, digest(tool, n))), names) for line in lines})
    forget(cache, days=60)
    repo.finish(faults)


if __name__ == "__main__":
    main()
