"""A folder of core/src includes only itself and the folders before it in PAVER_STAGES of core/CMakeLists.txt.

base/, mesh/ and quality/metrics.h are leaves that any folder may include (and that include only base/ and each other);
pipeline.cpp sees everything; cli/ sees only the public headers, worker/ and watch/ those and base/, formats/ those and
brep/. Only brep/, formats/ and topology/ include OpenCASCADE, only worker/ includes MPI.
"""
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../support"))
import repo  # noqa: E402

LEAVES = ("base", "mesh")
OPENCASCADE = re.compile(r"^(\w+_\w+|gp_?\w*|[A-Z][A-Za-z]+)\.hxx$")


def stages():
    listed = re.search(r"set\(PAVER_STAGES ([^)]*)\)", repo.text("core/CMakeLists.txt")).group(1)
    return listed.split()


def fault(order, folder, included):
    """Why a file of `folder` may not include `included`, or None."""
    if OPENCASCADE.match(included):
        allowed = folder in ("brep", "formats", "topology")
        return None if allowed else "only brep/, formats/ and topology/ include OpenCASCADE"
    if included == "mpi.h":
        return None if folder == "worker" else "only worker/ includes MPI"
    target = os.path.dirname(included).split("/")[0]
    if target == "paver" or not target:
        return None
    if target not in order:
        return None  # a library
    if folder == target:
        return None
    if included.endswith("_impl.h") and folder not in ("formats", "topology"):
        return "an _impl.h header includes OpenCASCADE"
    if folder not in order:
        seen = {"worker": "base", "watch": "base", "formats": "brep"}.get(folder)
        return None if target == seen else "only public headers here"
    if target in LEAVES or included == "quality/metrics.h":
        return None if folder not in LEAVES or target in LEAVES or target == "base" else "a leaf includes only leaves"
    return None if order.index(target) < order.index(folder) else f"{target}/ comes after {folder}/"


def main():
    order, faults = stages(), []
    for name in repo.files(".h", ".cpp", under="core"):
        if not name.startswith(("core/src/", "core/include/")):
            continue
        folder = name.split("/")[2] if name.count("/") > 2 else ""
        if name == "core/src/pipeline.cpp":
            continue
        public = name.startswith("core/include/")
        for number, line in enumerate(repo.text(name).splitlines(), 1):
            found = re.match(r'\s*#include [<"]([^>"]+)[>"]', line)
            if not found:
                continue
            reason = fault(order, folder, found.group(1))
            if public and os.path.dirname(found.group(1)).split("/")[0] in order:
                reason = "a public header includes only public headers"
            if reason:
                faults.append(f"{name}:{number}: {found.group(1)}: {reason}")
    repo.finish(faults)


if __name__ == "__main__":
    main()
