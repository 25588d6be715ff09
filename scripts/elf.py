"""Reads and changes programs and libraries for scripts/wheel.py, mostly by patchelf."""
import re
import struct
import subprocess

UNIQUE, WEAK = 10, 2  # how a symbol binds
DYNAMIC_SYMBOLS = 11  # kind of a section


def said(*command):
    """What a program prints; its own message when it fails."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL)
    except FileNotFoundError:
        raise SystemExit(f"wheel: there is no {command[0]}; run scripts/setup build package.") from None
    if done.returncode:
        raise SystemExit(f"wheel: {' '.join(command)} failed: {(done.stderr or done.stdout).strip()}")
    return done.stdout


def is_elf(path):
    with open(path, "rb") as file:
        return file.read(4) == b"\x7fELF"


def needed(path):
    """Names of the libraries that a file asks for itself."""
    return said("patchelf", "--print-needed", path).split()


def resolved(path):
    """{name: file or None} of all libraries that the loader finds for a file."""
    found = {}
    for line in said("ldd", path).splitlines():
        parts = re.match(r"\s*(\S+) => (not found|/\S.*?)(?: \(0x\w+\))?$", line)
        if parts:
            found[parts.group(1)] = None if parts.group(2) == "not found" else parts.group(2)
    return found


def relink(path, names, libraries, soname=None):
    """Has a file ask for its libraries by new names, in the folder `libraries` as seen from its own ("." the same)."""
    # One change at a time: patchelf 0.14 mixes up the names of several.
    said("patchelf", "--set-rpath", "$ORIGIN" if libraries == "." else "$ORIGIN/" + libraries, path)
    if soname:
        said("patchelf", "--set-soname", soname, path)
    for old in needed(path):
        if old in names:
            said("patchelf", "--replace-needed", old, names[old], path)


def part_unique_symbols(path):
    """Makes "unique" symbols plain weak ones: a process has each unique symbol once, whatever library it is in, so that
    two releases of OpenCASCADE in one process would share tables that they lay out differently."""
    with open(path, "rb") as file:
        image = bytearray(file.read())
    if image[4:6] != b"\x02\x01":
        raise SystemExit(f"wheel: {path} is not for a machine of 64 bits, little end first; make the wheel on one.")
    sections_at, = struct.unpack_from("<Q", image, 0x28)
    size, count = struct.unpack_from("<HH", image, 0x3A)
    for section in range(sections_at, sections_at + size * count, size):
        kind, = struct.unpack_from("<I", image, section + 4)
        if kind != DYNAMIC_SYMBOLS:
            continue
        start, length = struct.unpack_from("<QQ", image, section + 0x18)
        for symbol in range(start, start + length, 24):
            binding, what = image[symbol + 4] >> 4, image[symbol + 4] & 15
            if binding == UNIQUE:
                image[symbol + 4] = WEAK << 4 | what
    with open(path, "wb") as file:
        file.write(image)
