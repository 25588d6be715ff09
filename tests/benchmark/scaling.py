#!/usr/bin/python3
"""Times, memory and quality of large meshes on one process, on several, and on levels: prints markdown tables.

    tests/benchmark/scaling.py [--only wind levels patch huge serial] [--repeat 3] [--ranks-of 32 256]
    tests/benchmark/scaling.py --quick      small meshes; only that all runs end and checksums agree

Build `paver`, `paver_benchmarks` (for the floor) and `paver-worker` (for ranks; two threads stand in without it). Every
process has one thread. Wall times of whole processes, start and writing included: of runs in turns the fastest. The
exit code is 1 when a run fails or the same mesh has two checksums; no time is judged.

Floor: a point and its derivatives on the surface, once for every node of the mesh (paver_benchmarks, floor/...).

Simulated: this machine runs few ranks at once, the others are worked out from one process's report. With N ranks
- what each rank repeats counts in full: read, sizing, and what is left of topology, boundary, regions and paving
  without their tasks; so does the start of the processes: wall time less all stages, of a box of 24 elements;
- tasks are those measured: of topology (areas, volumes), of boundary (edges, crossing divisions), then regions and coarse meshes of large ones, then pieces
  of these, dearest first as the queues have them. Each goes to the rank that is free first, and after each queue all
  wait for the last (list scheduling);
- repair, join, curving, quality and write each treat a rank's own elements only, so they take the share of the rank
  that has most: a coarse mesh has none. So does the end, when the system takes the memory back: what wall time less all
  stages is above the start;
- messages, waiting for memory or disk that ranks share, and mpirun's own start are not in it.
The same sum for two ranks stands beside the measured time, to show how near it comes.
"""
import argparse
import functools
import glob
import heapq
import json
import math
import os
import subprocess
import sys
import tempfile
import threading
import time
import uuid

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ.get("PAVER_PROGRAM") or os.path.join(ROOT, "build", "core", "paver")
BENCHMARKS = os.path.join(os.path.dirname(os.path.dirname(PROGRAM)), "tests", "benchmark", "paver_benchmarks")
# mm^2, to choose a target length.
AREA = {"box": 24800, "wind_generator": 215630200, "conesphere_gap": 58592, "wavy_patch": 46900}
REPEATED = ("read", "topology", "sizing", "boundary", "regions", "paving")
SHARED_OUT = ("repair", "join", "curving", "quality", "write")
faults = []


class Memory(threading.Thread):
    """Peak memory of all processes with a variable of their own in the environment: the sum of each one's peak."""

    def __init__(self, mark):
        super().__init__(daemon=True)
        self.mark, self.peaks, self.is_over = mark.encode(), {}, threading.Event()

    def run(self):
        known = {}
        while not self.is_over.wait(0.05):
            for pid in filter(str.isdigit, os.listdir("/proc")):
                try:
                    if not known.get(pid):
                        with open(f"/proc/{pid}/environ", "rb") as f:
                            known[pid] = self.mark in f.read()
                    if known[pid]:
                        with open(f"/proc/{pid}/status") as f:
                            self.peaks[pid] = max(int(line.split()[1]) for line in f if line.startswith("VmHWM"))
                except (OSError, ValueError):
                    pass

    def stop(self):
        """MiB."""
        self.is_over.set()
        self.join()
        return sum(self.peaks.values()) / 1024


def size_of(model, elements):
    return math.sqrt(AREA[model] / elements)


def model_path(model):
    return glob.glob(os.path.join(ROOT, "Resources", "examples", model + ".*"))[0]


def run_once(model, elements, options, watch):
    """{"wall": s, "report": ..., "memory": MiB of all processes} of one process or one set of ranks."""
    with tempfile.TemporaryDirectory() as folder:
        out, report = os.path.join(folder, "mesh.msh"), os.path.join(folder, "report.json")
        mark = f"PAVER_RUN_OF_BENCHMARK={uuid.uuid4()}"
        command = [PROGRAM, "mesh", model_path(model), "-o", out, "--report",
                   report, "--size", repr(size_of(model, elements)), "--max-elements", str(4 * elements), "--quiet",
                   *([] if "--threads" in options else ["--threads", "1"]), *options]
        memory = Memory(mark)
        if watch:
            memory.start()
        start = time.perf_counter()
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              env={**os.environ, **dict([mark.split("=")])})
        wall = time.perf_counter() - start
        peak = memory.stop() if watch else 0
        if done.returncode:
            sys.exit(f"scaling: {' '.join(command)}: {(done.stdout + done.stderr).strip()}")
        with open(report) as f:
            return {"wall": wall, "report": json.load(f), "memory": peak}


def measure(model, elements, variants, repeat, watch=False):
    """{name: the fastest run} of {name: options}, run in turns; names that start alike must give one mesh."""
    best = {}
    for _ in range(repeat):
        for name, options in variants.items():
            run = run_once(model, elements, options, watch)
            if name not in best or run["wall"] < best[name]["wall"]:
                best[name] = run
    meshes = {}
    for name, run in best.items():
        meshes.setdefault(name.split(",")[0], set()).add(run["report"]["checksum"])
    for name, sums in meshes.items():
        if len(sums) > 1:
            faults.append(f"{model}, {elements} elements, {name}: {len(sums)} different meshes")
    return best


def two_workers():
    """(what to call them, options): two ranks, or two threads where ranks are not built."""
    text = subprocess.run([PROGRAM, "mesh", "--help"], capture_output=True, text=True).stdout
    if "--ranks" in text and os.path.exists(os.path.join(os.path.dirname(PROGRAM), "paver-worker")):
        return "2 ranks", ["--ranks", "2"]
    return "2 threads (ranks are not built)", ["--threads", "2"]


def count(run):
    quality = run["report"]["quality"]
    return quality["quads"] + quality["triangles"]


def floor_seconds(label):
    """Time of the floor benchmark MODEL/N, or None."""
    if not os.path.exists(BENCHMARKS):
        return None
    done = subprocess.run([BENCHMARKS, f"--benchmark_filter=^floor/{label}$", "--benchmark_format=json",
                           "--benchmark_repetitions=5"], capture_output=True, text=True)
    times = [b["real_time"] for b in json.loads(done.stdout)["benchmarks"] if b["run_type"] == "iteration"]
    return min(times) / 1000


# The simulation.

@functools.lru_cache(None)
def start_seconds():
    """Wall time less all stages where next to nothing is meshed."""
    runs = [run_once("box", 24, [], False) for _ in range(5)]
    return min(run["wall"] - sum(run["report"]["stage_seconds"].values()) for run in runs)


def schedule(tasks, ranks):
    """(when the last rank is done, elements of each) of tasks in the order of the queue."""
    free = [(0.0, rank) for rank in range(ranks)]
    laid = [0] * ranks
    for seconds, elements in tasks:
        start, rank = heapq.heappop(free)
        heapq.heappush(free, (start + seconds, rank))
        laid[rank] += elements
    return max(free)[0], laid


def simulate(run, ranks):
    """{part: seconds} with that many ranks."""
    stages, tasks = run["report"]["stage_seconds"], run["report"]["tasks"]
    parts = {stage: stages.get(stage, 0) for stage in REPEATED[:5]}
    paving = sum(seconds for stage in ("regions", "paving") for seconds, _ in tasks.get(stage, []))
    for stage in ("topology", "boundary"):
        parts[stage] = max(0.0, parts[stage] - sum(seconds for seconds, _ in tasks.get(stage, [])))
        parts[f"tasks of {stage}"] = schedule(tasks.get(stage, []), ranks)[0]
    parts["rest of paving"] = max(0.0, stages.get("paving", 0) - paving)
    parts["regions, coarse meshes"], of_regions = schedule(tasks.get("regions", []), ranks)
    parts["pieces"], of_pieces = schedule(tasks.get("paving", []), ranks)
    laid = [a + b for a, b in zip(of_regions, of_pieces)]
    share = max(laid) / sum(laid) if sum(laid) else 1
    for stage in SHARED_OUT:
        parts[stage] = stages.get(stage, 0) * share
    outside = max(0.0, run["wall"] - sum(stages.values()))
    parts["start"] = min(outside, start_seconds())
    parts["end"] = (outside - parts["start"]) * share
    return parts


def share_table(run):
    """What one rank repeats or cannot share, by stage, of the wall time."""
    parts = simulate(run, 1)
    serial = [*REPEATED[:5], "rest of paving", "start"]
    rows = [[name, f"{1000 * parts[name]:.0f}", f"{parts[name] / run['wall']:.1%}"] for name in serial]
    total = sum(parts[name] for name in serial)
    rows.append(["all of these", f"{1000 * total:.0f}", f"{total / run['wall']:.1%}"])
    return rows


# The tables.

def table(title, head, rows):
    print(f"\n{title}\n\n| {' | '.join(head)} |\n|{'---|' * len(head)}")
    for row in rows:
        print(f"| {' | '.join(str(cell) for cell in row)} |")
    sys.stdout.flush()


def wind(a):
    elements = 20000 if a.quick else 441409
    two, options = two_workers()
    runs = measure("wind_generator", elements, {"mesh": [], "mesh, " + two: options}, a.repeat)
    one, both = runs["mesh"], runs["mesh, " + two]
    start = measure("box", 24, {"mesh, " + two: options}, a.repeat)["mesh, " + two]["wall"]
    rows = [["elements", f"{count(one):,}", ""], ["one core", f"{one['wall']:.2f} s", "about 5 s"]]
    floor = None if a.quick else floor_seconds(f"wind_generator/{elements}")
    if floor:
        rows += [["floor", f"{floor:.3f} s", ""], ["one core / floor", f"{one['wall'] / floor:.1f}", "<= 20"]]
    rows.append([two, f"{both['wall']:.2f} s, {one['wall'] / both['wall']:.2f} times as fast", ">= 1.85"])
    rows.append([f"{two}, a box of 24 elements", f"{start:.2f} s", ""])
    for ranks in [2, *a.ranks_of]:
        parts = simulate(one, ranks)
        wanted = {32: ">= 25", 256: ">= 150"}.get(ranks, "")
        total = sum(parts.values())
        rows.append([f"{ranks} ranks, simulated", f"{total:.2f} s, {one['wall'] / total:.2f} times as fast", wanted])
    table("Wind generator, order 2", ["", "", "required"], rows)
    both_parts = [simulate(one, ranks) for ranks in a.ranks_of]
    table("Where simulated ranks spend their time, ms", ["part", *[f"{n} ranks" for n in a.ranks_of]],
          [[name, *[f"{1000 * parts[name]:.0f}" for parts in both_parts]] for name in both_parts[0]])


def levels(a):
    elements = 60000 if a.quick else 530000
    on = "4" if a.quick else "auto"
    for order in ("1", "2"):
        on_levels, (two, options) = ["--multilevel", on, "--order", order], two_workers()
        runs = measure("conesphere_gap", elements, {"direct": ["--multilevel", "off", "--order", order],
                                                    "levels": on_levels, "levels, " + two: on_levels + options},
                       a.repeat)
        rows, quality = [], {name: run["report"]["quality"] for name, run in runs.items()}
        direct, level = runs["direct"], runs["levels"]
        for name in ("direct", "levels"):
            q, run = quality[name], runs[name]
            rows.append([name, f"{count(run):,}", f"{run['wall']:.2f}", f"{count(run) / run['wall']:,.0f}",
                         f"{q['irregular_share']:.3%}", f"{q['sj']['all']['mean']:.4f}", f"{q['length_cv']:.4f}"])
        irregular = [max(1e-9, quality[name]["irregular_share"]) for name in ("levels", "direct")]
        rows.append(["levels / direct", "", f"{level['wall'] / direct['wall']:.2f}", "",
                     f"{irregular[0] / irregular[1]:.2f}", "", ""])
        rows.append(["required", "", "<= 0.25", "floor / 5", "<= 0.25", "no worse", "no worse"])
        if not a.quick and order == "2":
            floor = floor_seconds(f"conesphere_gap/{elements}")
            if floor:
                rows.append(["floor", "", f"{floor:.2f}", f"{count(level) / floor:,.0f}", "", "", ""])
        table(f"Cone-sphere with a groove, order {order}, one core",
              ["", "elements", "s", "elements/s", "irregular", "mean SJ", "length CV"], rows)


def patch(a):
    elements = 80000 if a.quick else 1000000
    two, options = two_workers()
    runs = measure("wavy_patch", elements, {"mesh": [], "mesh, " + two: options}, a.repeat)
    one, both = runs["mesh"], runs["mesh, " + two]
    table("One B-spline face, order 2", ["", "", "required"],
          [["elements", f"{count(one):,}", ""], ["one core", f"{one['wall']:.2f} s", ""],
           [two, f"{both['wall']:.2f} s, {one['wall'] / both['wall']:.2f} times as fast", ">= 1.8"],
           ["2 ranks, simulated", f"{one['wall'] / sum(simulate(one, 2).values()):.2f} times as fast", ""]])


def huge(a):
    two, options = two_workers()
    rows, first = [], None
    for elements in (20000, 100000) if a.quick else (500000, 10000000):
        repeat = a.repeat if first is None else 1
        variants = {"mesh": [], "mesh, " + two: options}
        runs = measure("conesphere_gap", elements, variants, repeat, watch=True)
        cost = {name: run["wall"] / count(run) * 1e6 for name, run in runs.items()}
        first = first or cost
        for name, run in runs.items():
            rows.append([name.split(", ")[-1].replace("mesh", "one process"), f"{count(run):,}", f"{run['wall']:.1f}",
                         f"{cost[name]:.2f}", f"{cost[name] / first[name]:.2f}", f"{run['memory'] / 1024:.2f}"])
    rows.append(["required", "", "", "", "<= 1.3", "<= 8"])
    table("Cone-sphere with a groove on levels, order 2; memory is the sum over all processes",
          ["", "elements", "s", "µs per element", "by that of the first", "GiB"], rows)


def serial(a):
    elements = 20000 if a.quick else 500000
    for model in ("wind_generator", "conesphere_gap"):
        run = measure(model, elements, {"mesh": []}, a.repeat)["mesh"]
        table(f"What every rank repeats, {model}, {count(run):,} elements, order 2, {run['wall']:.2f} s on one core "
              "(required: 3 %)", ["stage", "ms", "share"], share_table(run))


TABLES = {"wind": wind, "levels": levels, "patch": patch, "huge": huge, "serial": serial}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", nargs="+", choices=TABLES, default=list(TABLES))
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--repeat", type=int, default=0)
    parser.add_argument("--ranks-of", type=int, nargs="+", default=[32, 256], help="numbers of ranks to simulate")
    a = parser.parse_args()
    a.repeat = a.repeat or (1 if a.quick else 3)
    for name in a.only:
        TABLES[name](a)
    print(f"\nLoad average {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores: where other programs run, several ranks and "
          "threads are slower than they could be.")
    print("\n" + ("\n".join(faults) or "Meshes that should be the same have the same checksum."))
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
