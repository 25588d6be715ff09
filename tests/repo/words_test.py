"""The core uses the words of core/docs/glossary.md: none of its third column, "do not say"."""
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../support"))
import repo  # noqa: E402


def forbidden():
    """{phrase: word to say instead}."""
    words = {}
    for line in repo.text("core/docs/glossary.md").splitlines():
        cells = [c.strip() for c in line.strip().strip("|").split("|")]
        if len(cells) == 3 and cells[0] != "word" and not set(cells[0]) <= set("-: "):
            for phrase in filter(None, (p.strip() for p in cells[2].split(","))):
                words[phrase] = cells[0]
    return words


def main():
    words, faults = forbidden(), []
    pattern = re.compile(r"(?<![a-z])(" + "|".join(re.escape(w).replace(r"\ ", "[ _]") for w in words) +
                         r")(?:s|es|ed|ing)?(?![a-z])", re.I)
    for name in repo.files(".h", ".cpp", ".md", under="core"):
        if name.endswith("glossary.md") or name.startswith("core/docs/decisions/"):
            continue
        for number, line in enumerate(repo.text(name).splitlines(), 1):
            if line.lstrip().startswith("#include"):
                continue
            for found in pattern.findall(line):
                faults.append(f"{name}:{number}: say \"{words[found.lower().replace('_', ' ')]}\", not \"{found}\"")
    if not words:
        faults.append("core/docs/glossary.md has no table")
    repo.finish(faults)


if __name__ == "__main__":
    main()
