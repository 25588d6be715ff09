"""Damaged files (support/damage.py), each through the command line, and all of them through one Python that must live.

    damaged_files.py FIRST COUNT [--jobs N] [--keep FOLDER]    one line per file, then the table of core/docs/decisions/

A file passes when the program ends by itself within 60 seconds of processor time and 8 GiB, says one sentence unless all
is well, and leaves a whole mesh or none. --keep: copies of files on which the CAD kernel broke down, and of those that fail.
"""
import collections
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
import os
import resource
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import damage  # noqa: E402
import runs  # noqa: E402

MEMORY = 8 << 30
MOST_SECONDS = 60
ELEMENTS = 20_000
BROKEN, ENDLESS = "the CAD kernel broke down", "the CAD kernel came to no end"
BUILD = os.path.dirname(os.path.dirname(os.path.abspath(runs.PROGRAM)))

SURVIVOR = """
import sys
sys.path.insert(0, sys.argv[1])
import paver
for path in sys.stdin:
    try:
        paver.predict(path.rstrip("\\n"), size=1e3)
        print("read", flush=True)
    except paver.Error as error:
        print(str(error).replace("\\n", " "), flush=True)
"""


@dataclass
class Outcome:
    number: int
    original: str
    kind: str
    code: int
    error: str
    fault: str = ""  # not empty: what must not be

    def result(self):
        for words in (BROKEN, ENDLESS):
            if words in self.error:
                return words
        return {0: "meshed", 3: "refused", 4: "meshed but for some faces"}.get(self.code, "another error")


def set_limits():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (MOST_SECONDS, MOST_SECONDS))


def write(number, folder):
    """(original, kind, path) of a damaged file, made in a folder."""
    original, kind, content = damage.damaged(number)
    path = os.path.join(folder, f"{number}{os.path.splitext(original)[1]}")
    with open(path, "wb") as file:
        file.write(content)
    return os.path.basename(original), kind, path


def fault_of(code, error, left):
    lines = [line for line in error.splitlines() if line.strip()]
    if code < 0 or "was ended by signal" in error:
        return f"ended by a signal: {error}"
    if code and not (len(lines) == 1 and lines[0].startswith("paver: ") and lines[0].endswith(".")):
        return f"says more or less than one sentence: {error}"
    unfinished = [name for name in left if not name.endswith(".msh")]
    return f"left {unfinished}" if unfinished or (left and code not in (0, 4)) else ""


def run(number, size, keep=None):
    """Outcome of one file in the command line."""
    with tempfile.TemporaryDirectory() as folder:
        original, kind, path = write(number, folder)
        done = subprocess.run([runs.PROGRAM, "mesh", path, "-o", os.path.join(folder, "out.msh"), "--size", str(size),
                               "--max-elements", str(ELEMENTS), "--threads", "1"], stdin=subprocess.DEVNULL,
                              capture_output=True, preexec_fn=set_limits)
        error = done.stderr.decode(errors="replace").strip()
        left = set(os.listdir(folder)) - {os.path.basename(path)}
        outcome = Outcome(number, original, kind, done.returncode, error, fault_of(done.returncode, error, left))
        if keep and (outcome.fault or BROKEN in error or ENDLESS in error):
            shutil.copy(path, os.path.join(keep, f"{number}_{kind}_{original}"))
    return outcome


def sizes():
    """A target length per original, a twelfth of its diagonal."""
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        for path in damage.originals():
            report = runs.paver(path, os.path.join(folder, "a.msh"), "--size", 1e4).report
            found[os.path.basename(path)] = report["model"]["diagonal"] / 12 if report else 10
    return found


def survive(numbers):
    """What one Python says of each file; short when it has died."""
    with tempfile.TemporaryDirectory() as folder:
        paths = [write(number, folder)[2] for number in numbers]
        done = subprocess.run(["/usr/bin/python3", "-c", SURVIVOR, os.path.join(runs.ROOT, "bindings")],
                              input="\n".join(paths) + "\n", capture_output=True, text=True, errors="replace",
                              env={**os.environ, "PAVER_BUILD": BUILD})
    return done.returncode, done.stdout.splitlines()


def has_module():
    folder = os.path.join(BUILD, "bindings")
    return os.path.isdir(folder) and any(name.startswith("_paver.") for name in os.listdir(folder))


def main():
    given = runs.seed_arguments(__doc__)
    numbers, known = range(given.first, given.first + given.count), sizes()
    table, faults = collections.Counter(), 0

    def one(number):
        return run(number, known[os.path.basename(damage.damaged(number)[0])], given.keep)

    with ThreadPoolExecutor(given.jobs) as pool:
        for outcome in pool.map(one, numbers):
            table[damage.format_of(outcome.original), outcome.result()] += 1
            faults += bool(outcome.fault)
            print(*(str(part).replace("\n", " ") for part in vars(outcome).values()), sep="\t", flush=True)
    for (form, result), count in sorted(table.items()):
        print(f"| {form} | {result} | {count} |")
    code, said = survive(numbers)
    print(f"{faults} faults; Python ended with {code} after {len(said)} of {len(numbers)} files")
    return 1 if faults or code or len(said) != len(numbers) else 0


if __name__ == "__main__":
    sys.exit(main())
