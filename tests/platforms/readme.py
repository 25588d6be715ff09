#!/usr/bin/python3
"""Follows README.md word for word: all its commands, one after the other, in a folder that is empty at first.

    tests/platforms/readme.py

Run it on a machine that may be changed: it installs packages. Its clone comes from this checkout, whatever address the
README gives, and has no folder `shared` beside it. Ends with "all commands work", or at the first that does not.
"""
import os
import re
import subprocess
import sys
import tempfile

CHECKOUT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def blocks(text):
    """The indented blocks of a markdown text, without their indent."""
    found = re.findall(r"(?<=\n\n)((?:    .*\n|\n(?=    ))+)", text)
    return [re.sub(r"^    ", "", block, flags=re.M) for block in found]


def is_python(block):
    return block.startswith(("import ", "from "))


def script(text):
    """One script of all blocks: each goes on in the folder that the one before has come to."""
    parts = ["set -ex\n"]
    for block in blocks(text):
        parts.append(f"/usr/bin/python3 - <<'END OF PYTHON'\n{block}END OF PYTHON\n" if is_python(block) else block)
    return "".join(parts)


def address(text):
    """What the README clones from."""
    return re.search(r"git clone (\S+)", text).group(1)


def main():
    with open(os.path.join(CHECKOUT, "README.md"), encoding="utf-8") as file:
        text = file.read()
    text = text.replace(address(text), CHECKOUT)
    safe = {"GIT_CONFIG_COUNT": "1", "GIT_CONFIG_KEY_0": "safe.directory", "GIT_CONFIG_VALUE_0": "*"}
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(["bash", "-c", script(text)], cwd=folder, stdin=subprocess.DEVNULL,
                              env={**os.environ, **safe})
    print("all commands work" if done.returncode == 0 else f"a command ended with {done.returncode}")
    sys.exit(1 if done.returncode else 0)


if __name__ == "__main__":
    main()
