"""Meshes are the same files, byte for byte, on every machine: same_bytes.csv says which.

    same_bytes_test.py examples | cad      compares; cad: the models of the shared folder
    same_bytes_test.py --record            writes same_bytes.csv anew: once other meshes are wanted
"""
from concurrent.futures import ThreadPoolExecutor
import csv
import hashlib
import os
import re
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "../support"))
import repo  # noqa: E402
import runs  # noqa: E402

TABLE = os.path.join(HERE, "same_bytes.csv")
FIELDS = ("set", "file", "size", "sha256")


def rows():
    with open(TABLE, newline="") as file:
        return list(csv.DictReader(file))


def path_of(row):
    return os.path.join(runs.EXAMPLES, row["file"]) if row["set"] == "examples" else runs.need_shared("cad", row["file"])


def digest(path, size, folder):
    """SHA-256 of the mesh of a model; a sentence where there is none."""
    out = os.path.join(folder, os.path.basename(path) + ".msh")
    run = runs.paver(path, out, "--size", size, "--threads", 1)
    if run.mesh is None:
        return f"no mesh, exit code {run.code}: {run.output.strip()[-300:]}"
    with open(out, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def is_digest(text):
    return re.fullmatch("[0-9a-f]{64}", text) is not None


def digests(table):
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(pool.map(lambda row: digest(path_of(row), row["size"], folder), table))


def record():
    table = rows()
    for row, made in zip(table, digests(table)):
        if not is_digest(made):
            sys.exit(f"{row['file']}: {made}")
        row["sha256"] = made
    with open(TABLE + ".new", "w", newline="") as file:
        writer = csv.DictWriter(file, FIELDS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(table)
    os.replace(TABLE + ".new", TABLE)


def main(arguments):
    if arguments == ["--record"]:
        return record()
    table = [row for row in rows() if row["set"] in arguments]
    if not table:
        sys.exit(__doc__)
    faults = [f"{row['file']} at {row['size']} mm: {made}, not {row['sha256']}; where another mesh is meant, run "
              "tests/property/same_bytes_test.py --record"
              for row, made in zip(table, digests(table)) if made != row["sha256"]]
    print(f"{len(table)} meshes")
    repo.finish(faults)


if __name__ == "__main__":
    main(sys.argv[1:])
