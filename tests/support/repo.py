"""The repository's own text files, for the tests in tests/repo."""
import os
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SKIP, FAIL = 77, 1


def files(*endings, under=""):
    """Paths relative to ROOT: tracked files and new ones that git does not ignore."""
    listed = subprocess.run(["git", "-c", "safe.directory=*", "ls-files", "-co", "--exclude-standard", under or "."],
                            cwd=ROOT, capture_output=True, text=True)
    if listed.returncode == 0:
        names = listed.stdout.splitlines()
    else:  # an unpacked archive
        names = [os.path.relpath(os.path.join(folder, name), ROOT)
                 for folder, _, found in os.walk(os.path.join(ROOT, under)) if "build" not in folder for name in found]
    return sorted({n for n in names if n.endswith(endings or ("",)) and os.path.isfile(os.path.join(ROOT, n))})


def text(name):
    """Content of a file, or None when it is not text."""
    with open(os.path.join(ROOT, name), "rb") as f:
        data = f.read()
    try:
        return None if b"\0" in data else data.decode()
    except UnicodeDecodeError:
        return None


def finish(faults):
    """Prints the faults and ends the test."""
    for fault in faults:
        print(fault)
    print(f"{len(faults)} faults")
    sys.exit(FAIL if faults else 0)


def skip(reason):
    """Ends the test as skipped; in CI nothing that is needed may be missing."""
    print(("failed, in CI nothing may be skipped: " if os.environ.get("CI") == "true" else "skipped: ") + reason)
    sys.exit(FAIL if os.environ.get("CI") == "true" else SKIP)
