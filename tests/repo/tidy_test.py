"""The checks of .clang-tidy hold in core/src, except brep/, formats/ and topology/, whose OpenCASCADE headers take
too long.

What clang 14 cannot compile of C++20 is no fault: gcc is the compiler. Files without complaint are remembered in the
build folder, by their own content and that of all headers, and not looked at again.

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

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../support"))
import repo  # noqa: E402


def digest(*names):
    """One number for the contents of files."""
    total = hashlib.sha256()
    for name in names:
        total.update(f"{name}\0{repo.text(name)}\0".encode())
    return total.hexdigest()[:32]


def check(build, name, common):
    """Lines of complaint about one source file."""
    known = os.path.join(build, "tidy", f"{digest(name)}_{common}")
    if os.path.exists(known):
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


def main():
    build = sys.argv[1] if len(sys.argv) > 1 else os.path.join(repo.ROOT, "build")
    commands = os.path.join(build, "compile_commands.json")
    if not shutil.which("clang-tidy") or not os.path.exists(commands):
        repo.skip("clang-tidy or compile_commands.json is missing")
    with open(commands) as f:
        compiled = {os.path.relpath(c["file"], repo.ROOT) for c in json.load(f)}
    names = sorted(n for n in compiled if n.startswith("core/src/") and n.split("/")[2] not in ("brep", "formats", "topology"))
    common = digest(".clang-tidy", *repo.files(".h", under="core"))
    os.makedirs(os.path.join(build, "tidy"), exist_ok=True)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        faults = sorted({line for lines in pool.map(lambda n: check(build, n, common), names) for line in lines})
    repo.finish(faults)


if __name__ == "__main__":
    main()
