# SPDX-License-Identifier: BSD-3-Clause
"""Kills runs at random moments and restarts them. Usage: test_kill_and_restart.py ANVIL FORMAT

A run that is killed must leave a series, a history and checkpoints that can be read; restarted, it must end with the
same bytes in every frame, the history and the checkpoints as a run that was never disturbed.
"""
import filecmp
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

ANVIL = str(pathlib.Path(sys.argv[1]).resolve())
FORMAT = sys.argv[2]
KILLS = 6

# Coarse enough to take a second or two, with frames and checkpoints at steps that do not coincide.
SCENE = ["rod_square", "--set", "discretisation.spacing=1.6e-3", "--set", "time.end=40e-6", "--set",
         "output.interval=1e-6", "--set", "output.checkpoint_interval=2.7e-6", "--set", f"output.format={FORMAT}"]


def start(arguments):
    return subprocess.Popen([ANVIL, "run", *arguments, "--quiet"])


def run(arguments):
    if start(arguments).wait() != 0:
        sys.exit("a run that was not killed failed")


def last_checkpoint(result):
    found = {int(path.stem.split("_")[1]): path for path in result.glob("checkpoint_*.h5")}
    return found[max(found)] if found else None


def next_start(result):
    """How a user goes on after a crash: from the last checkpoint, or again when there is none."""
    checkpoint = last_checkpoint(result)
    return ["--restart", checkpoint] if checkpoint else [*SCENE, "-o", result]


def check_readable(result):
    for path in [*result.glob("frames/rod*"), *result.glob("checkpoint_*")]:
        subprocess.run([ANVIL, "info", path], check=True, stdout=subprocess.DEVNULL)
    history = result / "history.csv"
    if history.exists():
        lines = history.read_text().split("\n")[:-1]  # what follows the last newline may be torn
        assert len({line.count(",") for line in lines}) <= 1, "torn rows inside history.csv"


def names(result):
    kept = [path.relative_to(result) for path in result.rglob("*") if path.is_file() and path.name != "run.json"]
    return sorted(str(path) for path in kept)


def check_same(undisturbed, killed):
    assert names(undisturbed) == names(killed), (names(undisturbed), names(killed))
    different = [name for name in names(undisturbed) if not filecmp.cmp(undisturbed / name, killed / name, False)]
    assert not different, f"other bytes in {different}"


def main():
    seed = random.randrange(10**6)
    print(f"seed {seed}")
    moments = random.Random(seed)
    with tempfile.TemporaryDirectory() as folder:
        undisturbed, killed = pathlib.Path(folder) / "undisturbed", pathlib.Path(folder) / "killed"
        begin = time.monotonic()
        run([*SCENE, "-o", undisturbed])
        whole = time.monotonic() - begin
        hits = 0
        for _ in range(KILLS):
            process = start(next_start(killed))
            time.sleep(moments.uniform(0.02, 0.5) * whole)
            process.send_signal(signal.SIGKILL)
            hits += process.wait() == -signal.SIGKILL
            if killed.exists():
                check_readable(killed)
        run(next_start(killed))
        check_same(undisturbed, killed)
        assert hits > 0, "no run was killed before its end"
        print(f"{hits} kills, {len(names(killed))} files with the same bytes as an undisturbed run")


main()
