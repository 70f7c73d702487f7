"""Rays against triangles: ours, Embree's and Mitsuba's."""

import array
import json
import math
import random
import subprocess

import polygons
from programs import RUNS, WORK, say

RAYS = 500_000


def measure(results, peers, scenes, bench):
    say("rays")
    path = WORK / "rays.bin"
    write_rays(path)
    faces = polygons.read(scenes["fine"])
    triangles = sum(len(face.corners) - 2 for face in faces)
    results.note("settings of peers-rays: triangles of the scene")
    told = subprocess.run(
        [bench, scenes["fine"], path, str(RUNS)], check=True, capture_output=True, text=True
    )
    told = json.loads(told.stdout)
    answers = {"build": told, **{k: {"id": k, **told[k]} for k in ("closest", "any")}}
    add_rays(results, triangles, "radiosity", answers)
    job = {"what": "rays", "obj": str(scenes["fine"]), "rays": str(path), "runs": RUNS}
    for peer in ("embreex", "mitsuba"):
        add_rays(results, triangles, peer, peers.ask(peer, job))


def add_rays(results, triangles, program, answers):
    for query in ("closest", "any"):
        if query in answers:
            answer = answers[query]
            memory = answer.get("memory", "")
            results.add(
                "peers-rays",
                "cornell-regular",
                f"{program} {query}",
                triangles,
                answer["seconds"],
                rays=RAYS,
                memory=memory,
            )
            hits = answer["hits"]
            results.note(f"{program}: {query}: {hits} of {RAYS} rays meet something")
    if "build" in answers:
        results.note(
            f"{program}: hierarchy built in {answers['build']['build']:.3f} s of CPU"
        )


def write_rays(path):
    """From a random point of the room towards another; how far that is comes last."""
    chance = random.Random(1)
    numbers = array.array("d")
    for _ in range(RAYS):
        a, b = ([chance.uniform(0.001, 5.499) for _ in range(3)] for _ in range(2))
        d = polygons.sub(b, a)
        reach = math.sqrt(polygons.dot(d, d))
        numbers.extend([*a, *(x / reach for x in d), reach])
    path.write_bytes(numbers.tobytes())
