"""Looks at processes of this machine, for tests in and outside of FreeCAD."""


def process(pid):
    """(parent, name, state) of a process, or None."""
    try:
        with open(f"/proc/{pid}/stat") as f:
            text = f.read()
    except OSError:
        return None
    name, rest = text[text.index("(") + 1:text.rindex(")")], text[text.rindex(")") + 2:].split()
    return int(rest[1]), name, rest[0]


def is_alive(pid):
    found = process(pid)
    return found is not None and found[2] != "Z"
