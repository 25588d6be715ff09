"""Damaged CAD files: whole ones of the examples and the shared folder with a few things wrong, the same for a number on
every machine. Each is of one kind:

    bytes     1 to 20 bytes anywhere are others
    cut       the end is missing from a random place on, but for the marks by which a reader knows the end
    numbers   1 to 5 numbers are 0, -1, tiny, huge, no numbers, or one of the file's others
    lines     1 to 5 lines (STEP: entities) are left out, repeated, or in each other's place
"""
import functools
import glob
import os
import random
import re

import runs

FORMATS = ("step", "step", "iges", "brep", "brep")
KINDS = ("bytes", "cut", "numbers", "lines")
ENDINGS = (".step", ".stp", ".igs", ".brep")
NUMBER = re.compile(rb"(?<![\w.#])[-+]?\d+(?:\.\d*)?(?:[eEdD][-+]?\d+)?")
REFERENCE = re.compile(rb"(?<=[#(,\s])\d+")
VALUES = (b"0", b"-1", b"1", b"2", b"1e300", b"-1e300", b"1e30", b"1e-300", b"NaN", b"inf", b"2147483647", b"-2147483648",
          b"99999999999999999999", b"1000000", b"0.", b"1.E+300")
MOST_BYTES = 400_000  # a file that takes long whole takes as long damaged


def originals():
    """The files that are damaged, small ones first."""
    shared = [p for folder in ("cad", "contact", "tips") for p in glob.glob(os.path.join(runs.SHARED, folder, "*"))]
    found = [p for p in runs.examples() + shared if p.endswith(ENDINGS) and os.path.getsize(p) <= MOST_BYTES]
    return sorted(found, key=lambda p: (os.path.getsize(p), os.path.basename(p)))


@functools.lru_cache(maxsize=None)
def content(path):
    with open(path, "rb") as file:
        return file.read()


def format_of(path):
    return {".igs": "iges", ".brep": "brep"}.get(os.path.splitext(path)[1], "step")


def other_bytes(data, dice, _):
    data = bytearray(data)
    for _ in range(dice.randint(1, 20)):
        data[dice.randrange(len(data))] = dice.choice((dice.randrange(256), dice.randrange(32, 127), ord("0") + dice.randrange(10)))
    return bytes(data)


def stated_lines(lines):
    """The last line of an IGES file: how many lines each section has."""
    counts = {letter: sum(line[72:73] == letter for line in lines) for letter in (b"S", b"G", b"D", b"P")}
    return b"".join(b"%s%7d" % item for item in counts.items()).ljust(72) + b"T      1\n"


def cut(data, dice, form):
    kept = data[:dice.randrange(len(data) // 50, len(data))]
    if form == "step":
        return kept + dice.choice((b"", b";", b");")) + b"\nENDSEC;\nEND-ISO-10303-21;\n"
    if form == "brep":
        return kept + dice.choice((b"", b"\n+1 0\n", b"\n*\n+1 0\n"))
    lines = kept.splitlines(keepends=True)[:-1]
    return b"".join(lines) + (stated_lines(lines) if dice.random() < 0.7 else data.splitlines(keepends=True)[-1])


def other_numbers(data, dice, form):
    numbers = list((REFERENCE if dice.random() < 0.4 else NUMBER).finditer(data)) or list(NUMBER.finditer(data))
    for found in sorted(dice.sample(numbers, min(len(numbers), dice.randint(1, 5))), key=lambda m: -m.start()):
        value = dice.choice(VALUES) if dice.random() < 0.7 else dice.choice(numbers).group()
        if form == "iges":  # fields have their columns
            value = value[:len(found.group())].rjust(len(found.group()))
        data = data[:found.start()] + value + data[found.end():]
    return data


def other_lines(data, dice, form):
    end = b";" if form == "step" else b"\n"
    parts = data.split(end)
    for _ in range(dice.randint(1, 5)):
        i, j = (dice.randrange(1, max(2, len(parts) - 3)) for _ in range(2))
        what = dice.choice(("swap", "drop", "repeat", "replace"))
        if what == "swap":
            parts[i], parts[j] = parts[j], parts[i]
        elif what == "drop":
            del parts[i]
        elif what == "repeat":
            parts.insert(i, parts[i])
        else:
            parts[i] = parts[j]
    return end.join(parts)


def damaged(number):
    """(path of the original, kind, bytes) of one damaged file."""
    dice = random.Random(f"damaged file {number}")
    form = dice.choice(FORMATS)
    files = [p for p in originals() if format_of(p) == form]
    path = files[int(len(files) * dice.random() ** 2.5)]
    kind = dice.choice(KINDS)
    change = {"bytes": other_bytes, "cut": cut, "numbers": other_numbers, "lines": other_lines}[kind]
    return path, kind, change(content(path), dice, format_of(path))
