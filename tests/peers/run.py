#!/usr/bin/env python3
"""Public programs on the same polygons as ours, measured in one run.

    python3 tests/peers/run.py --install      # once: a virtual environment for each peer
    python3 tests/peers/run.py                # measures; a peer that is not there is skipped

Results go to tests/peers/results-DATE.csv, and the tables of tests/peers/README.md are made
from them. Standard library only; what needs a package runs in that package's environment.
"""

import argparse
import datetime
import os
import platform
import statistics
import subprocess
import time

import factors
import irradiance
import rays
import tables
from programs import (
    HERE,
    PEERS,
    ROOT,
    SCENES,
    WORK,
    Peers,
    build,
    install,
    ours,
    say,
    version,
)
from record import Results
from worker import LONG

#: Longest edge of an element, scene units: 226 elements of the box, 150 of the cube.
CUBE_EDGE, RAY_EDGE = 0.2, 0.07


def export():
    def scene(name, folder, edge):
        ours(f"scenes {name} --export {SCENES / folder} --edge {edge}")
        return SCENES / folder / f"{name}.obj"

    return {
        "box": scene("cornell-regular", "elements", irradiance.EDGE),
        "cube": scene("furnace", "cube", CUBE_EDGE),
        "warm": scene("furnace", "warm", 0.5),
        "fine": scene("cornell-regular", "rays", RAY_EDGE),
    }


def provenance(peers, load, began):
    versions = ", ".join(
        f"{peer} {version(peer)}" for peer in PEERS if peer not in peers.out
    )
    commit = subprocess.run(
        ["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True
    ).stdout.strip()
    cores = {1: "one", 2: "two", 4: "four", 8: "eight"}.get(
        os.cpu_count(), str(os.cpu_count())
    )
    busy = "while other work ran" if load > 0.5 else "while no other work ran"
    starts = [f"radiosity {statistics.median(ours('scenes')[0] for _ in range(5)):.3f} s"]
    for peer, seconds in peers.startup.items():
        if seconds is not None:
            warm = peers.warm.get(peer)
            text = f"{peer} {seconds:.2f} s"
            starts.append(text + (f" ({warm:.2f} s with warming up)" if warm else ""))
    return [
        "command: python3 tests/peers/run.py",
        f"versions: radiosity at {commit}, {versions}, Python {platform.python_version()}",
        f"machine: {cores}-core {platform.machine()} machine, {platform.system()}",
        f"date: {datetime.date.today()}, measured in {time.time() - began:.0f} s {busy} "
        f"(load {load:.1f} at the beginning)",
        "seconds: CPU of one thread, user and system, median of `runs`; a run beyond "
        f"{LONG:g} s is not repeated",
        "ours: the whole process, with its start and reading the file; peers: reading aside, "
        "building the scene and all work after it, without start-up and warming up",
        "start-up, CPU: " + ", ".join(starts),
        "memory: peak of the process, of Python and its packages for peers",
        "error: peers-factors: largest of a factor on the cube, root mean square over all in "
        "the box, on `blocked squares` of the one that is known exactly; peers-irradiance: root mean square over area and channels, relative, "
        "and over the runs",
    ]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "--install", action="store_true", help="make the virtual environments, and end"
    )
    parser.add_argument(
        "--reference", type=int, metavar="ROUNDS", help="make reference.csv anew, and end"
    )
    parser.add_argument(
        "--tables", action="store_true", help="only make the tables of README.md anew"
    )
    asked = parser.parse_args()
    if asked.install:
        return install()
    if asked.tables:
        return tables.write(HERE)
    began, load = time.time(), os.getloadavg()[0]
    WORK.mkdir(parents=True, exist_ok=True)
    bench = build()
    scenes, peers, results = export(), Peers(), Results()
    if asked.reference:
        return irradiance.make_reference(peers, scenes, asked.reference)
    factors.measure(results, peers, scenes)
    irradiance.measure(results, peers, scenes)
    rays.measure(results, peers, scenes, bench)
    for old in HERE.glob("results-*.csv"):
        old.unlink()
    path = HERE / f"results-{datetime.date.today()}.csv"
    results.write(path, provenance(peers, load, began))
    tables.write(HERE)
    say(f"written: {path.relative_to(ROOT)}, in {time.time() - began:.0f} s")


if __name__ == "__main__":
    main()
