"""No text file names a folder of somebody's machine; what makes a folder of a free name may say how that looks."""
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../support"))
import repo  # noqa: E402

ROOTS = "home|root|work|Users|mnt|media"
LOCAL = re.compile(rf"(?<![\w./-])/(?:(?:{ROOTS})/\w|tmp/(?![\w -]*XXXXXX))|[A-Z]:\\\\?Users|127\.0\.0\.1")


def main():
    faults = []
    for name in repo.files():
        for number, line in enumerate((repo.text(name) or "").splitlines(), 1):
            if LOCAL.search(line):
                faults.append(f"{name}:{number}: {line.strip()[:120]}")
    repo.finish(faults)


if __name__ == "__main__":
    main()
