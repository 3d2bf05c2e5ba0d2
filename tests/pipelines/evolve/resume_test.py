"""A simulation that is killed again and again, or whose disk is full, and resumed gives the bytes of one that nobody
disturbed: frames, log and history. Random moments; KILLS in the environment says how many."""
import json
import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

source = pathlib.Path(sys.argv[1])
STEPS = "300"
kills = int(os.environ.get("KILLS", "100"))
random.seed(int(os.environ.get("SEED", "17")))
# Where a run is disturbed, the process is the tool's own, not one that collects documents (tests/documents).
ALONE = {**os.environ, "DOCUMENTS": ""}
STEP = "advect --flow vortex:period=2 --dt 0.005 | flipdelaunay | refine | coarsen | smoothcurves"
failures = []


def check(truth, text):
    if not truth:
        failures.append(text)
        print("FAIL:", text, file=sys.stderr)


def command(folder, numbered, resume=True, more=()):
    where = ["--frames", f"{folder}/frames/%04d.json"] if numbered else ["-o", f"{folder}/out.jsonl"]
    return ["evolve", "-q", *where, "--log", f"{folder}/log.jsonl", "--history", f"{folder}/history.csv", "--every", "7",
            "--steps", STEPS, *(["--resume"] if resume else []), *more, STEP, f"{folder}/../start.json"]


def without_seconds(folder):
    """Log and history, but for what the clock says."""
    log = []
    for line in (folder / "log.jsonl").read_text().splitlines():
        step = json.loads(line)
        for stage in step["stages"]:
            del stage["seconds"]
        log.append(step)
    rows = [row.split(",") for row in (folder / "history.csv").read_text().splitlines()]
    timed = {k for k, name in enumerate(rows[0]) if name.endswith(".seconds")}
    return log, [[cell for k, cell in enumerate(row) if k not in timed] for row in rows]


def frames(folder, numbered):
    if not numbered:
        return (folder / "out.jsonl").read_bytes()
    return b"".join(path.read_bytes() for path in sorted((folder / "frames").glob("*.json")))


def with_limit(size):
    """Runs in the child: files end at this size, as on a full disk."""
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
    return limit


def is_prefix(folder, whole, numbered):
    """Complete frames, but for the last one, are those of the whole run: the last may be a state that a signal has put
    there, or half a frame."""
    if numbered:
        files = sorted((folder / "frames").glob("*.json"))
        return whole.startswith(b"".join(path.read_bytes() for path in files[:-1]))
    path = folder / "out.jsonl"
    text = path.read_bytes() if path.exists() else b""
    complete = text[:text.rfind(b"\n") + 1]
    return whole.startswith(complete[:complete.rstrip(b"\n").rfind(b"\n") + 1])


def disturbed(top, numbered, whole, times, longest):
    folder = pathlib.Path(tempfile.mkdtemp(dir=top))
    ended = {}
    k = 0
    while k < times:  # disturbances; a run that comes to its end begins anew
        if k % 5 == 4:  # a disk that is full somewhere in a file
            size = random.randrange(1, 20000 if numbered else len(whole))
            result = subprocess.run(command(folder, numbered), preexec_fn=with_limit(size), env=ALONE,
                                    capture_output=True, timeout=250)
            check(result.returncode in (0, 5), f"full disk: status {result.returncode}, {result.stderr[:300]}")
            if result.returncode == 5 and not numbered and (folder / "out.jsonl").exists():
                text = (folder / "out.jsonl").read_bytes()
                check(not text or text.endswith(b"\n"), "a full disk left half a frame")
            status = result.returncode
        else:
            process = subprocess.Popen(command(folder, numbered), env=ALONE, stderr=subprocess.DEVNULL)
            time.sleep(random.uniform(0, longest))
            process.send_signal(signal.SIGKILL if k % 3 else signal.SIGTERM)
            status = process.wait(timeout=250)
            check(status in (0, -signal.SIGKILL, 143, -signal.SIGTERM), f"status {status}")
        ended[status] = ended.get(status, 0) + 1
        if status == 0:
            check(frames(folder, numbered) == whole, f"numbered {numbered}: the frames differ")
            shutil.rmtree(folder)
            folder.mkdir()
            continue
        k += 1
        check(is_prefix(folder, whole, numbered), "frames that the whole run does not have")
        if not numbered and (folder / "out.jsonl").exists() and random.random() < 0.3:
            with open(folder / "out.jsonl", "ab") as file:  # half a frame, as a crash of the machine leaves it
                file.write(b'{"format":"pliant-mesh","vers')
    print(f"runs ended with {ended}")
    result = subprocess.run(command(folder, numbered), capture_output=True, timeout=280)
    check(result.returncode == 0, f"the last run: {result.stderr[:300]}")
    return folder


def main():
    with tempfile.TemporaryDirectory() as top:
        top = pathlib.Path(top)
        with open(top / "start.json", "wb") as start:
            subprocess.run(["bspline2mesh", "--max-turning", "40", str(source / "samples/three-cells/cells.json")],
                           stdout=start, check=True)
        for numbered in (False, True):
            whole_folder = pathlib.Path(tempfile.mkdtemp(dir=top))
            start = time.monotonic()
            subprocess.run(command(whole_folder, numbered, resume=False), check=True)
            longest = 0.5 * (time.monotonic() - start)
            whole = frames(whole_folder, numbered)
            times = kills if not numbered else max(1, kills // 4)
            folder = disturbed(top, numbered, whole, times, longest)
            check(frames(folder, numbered) == whole, f"numbered {numbered}: the frames differ")
            check(without_seconds(folder) == without_seconds(whole_folder), f"numbered {numbered}: log or history differ")
            # Done is done: nothing changes.
            subprocess.run(command(folder, numbered), check=True)
            check(frames(folder, numbered) == whole, "a finished run changed")
            # Another step, or other frames, are wrong usage.
            other = [word.replace("0.005", "0.02") if word == STEP else word for word in command(folder, numbered)]
            check(subprocess.run(other, capture_output=True).returncode == 2, "another step was taken")
            other = ["8" if word == "7" else word for word in command(folder, numbered)]
            check(subprocess.run(other, capture_output=True).returncode == 2, "other frames were taken")
            check(frames(folder, numbered) == whole, "a refused run changed the frames")
            # The same as one that was meant to be longer from the start.
            longer = ["330" if word == STEPS else word for word in command(folder, numbered)]
            subprocess.run(longer, check=True)
            alone = pathlib.Path(tempfile.mkdtemp(dir=top))
            subprocess.run(["330" if word == STEPS else word for word in command(alone, numbered)], check=True)
            check(frames(folder, numbered) == frames(alone, numbered), "a longer run differs")
            check(without_seconds(folder) == without_seconds(alone), "the logs of a longer run differ")
    sys.exit(1 if failures else 0)


main()
