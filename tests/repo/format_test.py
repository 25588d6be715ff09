"""All C++ is as clang-format leaves it (.clang-format)."""
import os
import re
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../support"))
import repo  # noqa: E402


def main():
    if not shutil.which("clang-format"):
        repo.skip("clang-format is not installed")
    run = subprocess.run(["clang-format", "--dry-run", "--Werror", *repo.files(".h", ".cpp")], cwd=repo.ROOT,
                         capture_output=True, text=True, stdin=subprocess.DEVNULL)
    names = sorted(set(re.findall(r"^(\S+?):\d+:\d+: error:", run.stderr, re.MULTILINE)))
    faults = [f"{name}: not formatted: clang-format -i {name}" for name in names]
    if run.returncode and not faults:
        faults.append(run.stderr)
    repo.finish(faults)


if __name__ == "__main__":
    main()
