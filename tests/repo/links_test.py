"""Links between the pages, files and folders that pages name in code quotes, and works that the code cites exist."""
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../support"))
import repo  # noqa: E402

LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
CITATION = re.compile(r"\[([A-Z][a-z]+\d\d)[],]")
REFERENCES = "core/docs/references.md"
QUOTED = re.compile(r"`((?:core|scripts|tests|Resources|\.ci)/[\w./-]*)`")


def main():
    faults = []
    for name in repo.files(".md"):
        for number, line in enumerate(repo.text(name).splitlines(), 1):
            targets = [os.path.join(os.path.dirname(name), t.split("#")[0]) for t in LINK.findall(line)
                       if "://" not in t and not t.startswith(("#", "mailto:"))]
            targets += QUOTED.findall(line)
            for target in targets:
                if not os.path.exists(os.path.join(repo.ROOT, target)):
                    faults.append(f"{name}:{number}: {target} does not exist")
    known = set(CITATION.findall(repo.text(REFERENCES)))
    for name in repo.files(".h", ".cpp", ".py"):
        for number, line in enumerate(repo.text(name).splitlines(), 1):
            faults += [f"{name}:{number}: [{cited}] is not in {REFERENCES}" for cited in CITATION.findall(line)
                       if cited not in known]
    repo.finish(faults)


if __name__ == "__main__":
    main()
