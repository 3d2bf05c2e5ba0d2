#!/usr/bin/env python3
"""Random meshes moved as far as advect goes, or further, and repaired with the plain pipe: do they come out as good as new ones?

Each seed makes a domain with interfaces, a mesh of it with fields, and a flow. The mesh is advected, with nothing in between, until a
step is refused (with --tangled: and then two more are forced, as one). Then

    smoothcurves | flipdelaunay | refine | coarsen --tolerance 0 | smoothcurves

runs at the document's criteria, and what comes out is compared with a new mesh of the moved boundary: README.md beside this file.
Usage: repair_cases.py --bin build/release/bin --seeds 1-200 [--most-triangles N] [--tangled] [--msh] [--keep DIR] [--cache DIR]
"""
import argparse
import json
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from field_integrals import integrals
from random_cases import make_case, shrink_inner

PIPE = [["smoothcurves"], ["flipdelaunay"], ["refine"], ["coarsen", "--tolerance", "0"], ["smoothcurves"]]
MOST_STEPS = 60
FORCED = 2  # with --tangled, this many steps are forced as one
REFUSED = 4  # the status of a step that would invert an element
NO_END = -1  # the status of a tool that had to be stopped


class Tools:
    def __init__(self, folder, tool_seconds):
        self.folder = Path(folder).resolve()
        self.tool_seconds = tool_seconds

    def run(self, arguments, out=None):
        """Status, seconds, and what was said."""
        start = time.monotonic()
        with open(out, "wb") if out else open("/dev/null", "wb") as stream:
            try:
                done = subprocess.run([self.folder / arguments[0], *map(str, arguments[1:])], stdout=stream,
                                      stderr=subprocess.PIPE, timeout=self.tool_seconds)
            except subprocess.TimeoutExpired:
                return NO_END, time.monotonic() - start, f"no end within {self.tool_seconds:g} s"
        return done.returncode, time.monotonic() - start, done.stderr.decode()

    def report(self, mesh):
        done = subprocess.run([self.folder / "qualityreport", "--format", "json", "--bins", "0", "--worst", "0", mesh],
                              capture_output=True, check=True)
        return json.loads(done.stdout)


def prepare(tools, seed, folder, options):
    """Writes moved.json and fresh.json. Returns the case in words, and why there is no fresh mesh if there is none."""
    document, mesh, flow, step, word = make_case(seed, options.most_triangles)
    boundary, moved, work = folder / "boundary.json", folder / "moved.json", folder / "work.json"
    for _ in range(6):
        boundary.write_text(json.dumps(document))
        status, _, said = tools.run(["bspline2mesh", "-q", *mesh, boundary], moved)
        if status == 0 or not shrink_inner(document):
            break
    if status:
        raise RuntimeError(f"seed {seed}: bspline2mesh: {said}")
    steps = 0
    while steps < MOST_STEPS:
        status, _, said = tools.run(["advect", "-q", *flow, "--dt", step, moved], work)
        if status == REFUSED:
            break
        if status:
            raise RuntimeError(f"seed {seed}: advect ended with status {status}: {said}")
        work.replace(moved)
        steps += 1
    if options.tangled:
        # One long step, since the next would not read what is not valid.
        forced = ["--force", "--substeps", FORCED, "--dt", FORCED * step]
        status, _, said = tools.run(["advect", "-q", *forced, *flow, moved], work)
        if status:
            raise RuntimeError(f"seed {seed}: advect --force ended with status {status}: {said}")
        work.replace(moved)
    moved_mesh = json.loads(moved.read_text())
    again = {"format": "pliant-boundary", "version": 1, **moved_mesh["boundary"]}
    boundary.write_text(json.dumps(again))
    status, _, said = tools.run(["bspline2mesh", "-q", *mesh[:4], boundary], folder / "fresh.json")
    return f"{word}, {steps} steps of {step}", f"bspline2mesh ended with status {status}: {said}" if status else ""


# ---- what must hold


def least(report, metric):
    return report[metric]["min"]


def integral_faults(before, after):
    """Faults of the integrals that have changed. Inverted elements count with their negative areas."""
    was, now, faults = integrals(before), integrals(after), []
    for key, (value, absolute) in was.items():
        change = now.get(key, (0, 0))[0] - value
        if not abs(change) <= 1e-13 * absolute:
            faults.append(("integral", f"{key}: {change:.3g} of {absolute:.3g}"))
    return faults


def examine(tools, folder, times, statuses, options):
    """The faults of the repaired mesh, as a list of (kind, text)."""
    faults = [("status", f"{tool} ended with status {status}: {said.strip().splitlines()[-1] if said else ''}")
              for tool, status, said in statuses if status]
    if faults:
        return faults
    repaired, fresh = tools.report(folder / "repaired.json"), tools.report(folder / "fresh.json")
    if repaired["invalid"] or repaired.get("degenerate"):
        faults.append(("invalid", f"{repaired['invalid']} elements"))
    if repaired["faults"]:
        faults.append(("faults", str(repaired["faults"])[:200]))
    tau = least(repaired, "logical_tau")
    if not tau > 0:
        faults.append(("turned over", f"least logical tau {tau:.3g}"))
    moved = json.loads((folder / "moved.json").read_text())
    asked = moved.get("criteria", {}).get("min_angle", 20)
    bound = min(20, asked, least(fresh, "logical_angle"))
    for metric, limit, kind in (("logical_angle", bound - 1e-9, "angle"),
                                ("scaled_jacobian", min(0.25, 0.8 * least(fresh, "scaled_jacobian")), "jacobian"),
                                ("shape", min(0.2, 0.8 * least(fresh, "shape")), "shape")):
        if least(repaired, metric) < limit:
            faults.append((kind, f"{least(repaired, metric):.4g} where {limit:.4g} is asked for"))
    now, new = repaired["triangles"], fresh["triangles"]
    if now > 1.3 * new and now > new + 4:
        faults.append(("triangles", f"{now} where a new mesh has {new}"))
    read = json.loads((folder / "read.json").read_text()) if options.msh else moved
    faults += integral_faults(read, json.loads((folder / "repaired.json").read_text()))
    if sum(times) > options.most_seconds:
        faults.append(("time", f"{sum(times):.2f} s"))
    return faults


def run_case(tools, seed, options):
    name = f"{seed}{'t' if options.tangled else ''}-{options.most_triangles}"
    cache = Path(options.cache) / name if options.cache else None
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        if cache and cache.exists():
            shutil.copytree(cache, folder, dirs_exist_ok=True)
        else:
            (folder / "word").write_text("\n".join(prepare(tools, seed, folder, options)))
            if cache:
                shutil.copytree(folder, cache)
        word, _, no_fresh = (folder / "word").read_text().partition("\n")
        if no_fresh:  # Forced steps may tangle the boundary; that of a valid mesh is in order.
            if options.tangled:
                return {"seed": seed, "case": word, "skipped": no_fresh}
            return {"seed": seed, "case": word, "faults": [("fresh", no_fresh)]}
        if options.only_advect:
            return {"seed": seed, "case": word, "faults": []}
        source, times, statuses, criteria = folder / "moved.json", [], [], []
        if options.msh:
            statuses.append(("export-msh", *tools.run(["export-msh", "-q", source], folder / "moved.msh")[::2]))
            source = folder / "read.json"
            mesh = make_case(seed, options.most_triangles)[1]  # MSH has neither fields nor criteria.
            fields, criteria = mesh[4:], mesh[2:4]
            read = tools.run(["import-msh", "-q", *fields, folder / "moved.msh"], source)
            statuses.append(("import-msh", *read[::2]))
        for k, stage in enumerate(PIPE):
            target = folder / ("repaired.json" if k + 1 == len(PIPE) else f"stage{k + 1}.json")
            asked = criteria if stage[0] in ("refine", "coarsen") else []
            status, seconds, said = tools.run([*stage, *asked, "-q", source], target)
            times.append(seconds)
            statuses.append((stage[0], status, said))
            source = target
            if status:
                break
        faults = examine(tools, folder, times, statuses, options)
        if faults and options.keep:
            shutil.copytree(folder, Path(options.keep) / str(seed), dirs_exist_ok=True)
        count = tools.report(folder / "moved.json")["triangles"]
        return {"seed": seed, "case": word, "triangles": count, "seconds": [round(s, 3) for s in times], "faults": faults}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, help="folder of the tools")
    parser.add_argument("--seeds", default="1-200", help="A-B, or a list with commas")
    parser.add_argument("--most-triangles", type=float, default=10000)
    parser.add_argument("--most-seconds", type=float, default=1e9)
    parser.add_argument("--tool-seconds", type=float, default=30, help="a tool that takes longer is stopped: a fault")
    parser.add_argument("--jobs", type=int, default=1, help="cases at a time")
    parser.add_argument("--tangled", action="store_true", help="force two more steps, as one")
    parser.add_argument("--msh", action="store_true", help="through export-msh and import-msh, without curves' names")
    parser.add_argument("--keep", help="copies what fails to this folder")
    parser.add_argument("--cache", help="moved meshes are taken from here, and put here")
    parser.add_argument("--only-advect", action="store_true")
    parser.add_argument("--allowed", type=int, default=0, help="so many cases may fail")
    options = parser.parse_args()
    tools = Tools(options.bin, options.tool_seconds)
    if "-" in options.seeds:
        first, last = map(int, options.seeds.split("-"))
        seeds = range(first, last + 1)
    else:
        seeds = [int(s) for s in options.seeds.split(",")]
    kinds, failed, skipped = {}, [], 0
    with ThreadPoolExecutor(options.jobs) as pool:  # Threads suffice: the time goes into the tools.
        for result in pool.map(lambda seed: run_case(tools, seed, options), seeds):
            print(json.dumps(result), flush=True)
            skipped += "skipped" in result
            if result.get("faults"):
                failed.append(result["seed"])
                for kind in dict.fromkeys(kind for kind, _ in result["faults"]):
                    kinds.setdefault(kind, []).append(result["seed"])
    print(f"{len(seeds)} cases, {skipped} skipped, {len(failed)} failed: {failed}")
    for kind, found in sorted(kinds.items()):
        print(f"  {kind}: {len(found)}: {found}")
    sys.exit(len(failed) > options.allowed or skipped > len(seeds) // 4)


if __name__ == "__main__":
    main()
