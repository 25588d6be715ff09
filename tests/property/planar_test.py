"""Random planar regions at their own target length:  planar_test.py [COUNT], default 50.

All finish, nothing inverted, conforming; and over all of them together the quality that paving is to reach.
"""
from concurrent.futures import ThreadPoolExecutor
import os
import sys
import tempfile

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import runs  # noqa: E402

# Over all regions: smallest mean SJ and share of edges in 0.7 to 1.4 h, largest share of irregular nodes, triangles.
MEAN_SJ, IN_BAND, IRREGULAR, TRIANGLES = 0.93, 0.90, 0.15, 0.01


def check(path, h, folder):
    name = os.path.splitext(os.path.basename(path))[0]
    run = runs.paver(path, os.path.join(folder, name + ".msh"), "--size", h, "--order", 2, "--threads", 1, limit=60)
    if run.code != 0 or not run.report:
        return name, [f"exit code {run.code}: {run.output.strip()[-300:]}"], None
    quality = run.report["quality"]
    faults = runs.conformity(run.mesh, closed=False)
    if quality["inverted"]:
        faults.append(f"{quality['inverted']} inverted elements")
    if runs.hanging_nodes(run.mesh):
        faults.append("hanging nodes")
    return name, faults, quality


def main():
    regions = runs.planar_regions(int(sys.argv[1]) if len(sys.argv) > 1 else 50)
    faults, all_quality = [], []
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        for name, found, quality in pool.map(lambda r: check(*r, folder), regions):
            faults += [f"{name}: {f}" for f in found]
            all_quality += [quality] if quality else []
    if all_quality:
        def mean(get):
            return float(np.mean([get(q) for q in all_quality]))
        figures = {"mean SJ": (mean(lambda q: q["sj"]["all"]["mean"]), MEAN_SJ, 1),
                   "share of edges in 0.7 to 1.4 h": (mean(lambda q: q["length_in_band"]), IN_BAND, 1),
                   "irregular share": (mean(lambda q: q["irregular_share"]), IRREGULAR, -1),
                   "triangles": (mean(lambda q: q["triangles"] / (q["quads"] + q["triangles"])), TRIANGLES, -1)}
        for what, (value, limit, sign) in figures.items():
            print(f"{what}: {value:.4f} (limit {limit})")
            if sign * value < sign * limit:
                faults.append(f"{what} {value:.4f}, limit {limit}")
    print("\n".join(faults) or "good")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
