"""All C++ is as clang-format leaves it (.clang-format)."""
import os
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../support"))
import repo  # noqa: E402


def main():
    if not shutil.which("clang-format"):
        repo.skip("clang-format is not installed")
    faults = []
    for name in repo.files(".h", ".cpp"):
        run = subprocess.run(["clang-format", "--dry-run", "--Werror", name], cwd=repo.ROOT, capture_output=True,
                             text=True, stdin=subprocess.DEVNULL)
        if run.returncode:
            faults.append(f"{name}: not formatted: clang-format -i {name}")
    repo.finish(faults)


if __name__ == "__main__":
    main()
