"""View-factor matrices: ours and pyviewfactor's, against exact values."""

import array
import math
import struct
from pathlib import Path

import exact
import polygons
from programs import RUNS, SCENES, WORK, ours, ours_timed, say
from record import mean_square


def read_npy(path):
    data = Path(path).read_bytes()
    length = struct.unpack("<H", data[8:10])[0]
    return array.array("d", data[10 + length :])


def read_raw(path):
    return array.array("d", Path(path).read_bytes())


def largest(found, expected):
    return max(abs(a - b) for a, b in zip(found, expected))


#: Opposite unit squares 1 apart, and a quarter of the plane between them opaque: by
#: symmetry the factor is 3/4 of the free one.
FREE = 0.199824895698387
QUARTER_HIDDEN = 0.75 * FREE
GRID = 6


def blocked_squares(path):
    """Each square as a grid of faces; then the opaque quarter."""
    lines, faces = [], 0

    def square(x, y, size, z, up):
        nonlocal faces
        corners = [(x, y), (x + size, y), (x + size, y + size), (x, y + size)]
        for u, v in corners if up else corners[::-1]:
            lines.append(f"v {u!r} {v!r} {z!r}")
        lines.append(f"f {4 * faces + 1} {4 * faces + 2} {4 * faces + 3} {4 * faces + 4}")
        faces += 1

    for z, up, n in ((0.0, True, GRID), (1.0, False, GRID), (0.5, True, GRID // 2)):
        for i in range(n):
            for j in range(n):
                square(i / GRID, j / GRID, 1 / GRID, z, up)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + "\n")
    return path


def squares_factor(matrix):
    n = GRID * GRID
    count = 2 * n + (GRID // 2) ** 2
    total = math.fsum(matrix[i * count + n + j] for i in range(n) for j in range(n))
    return total / n


OUR_SETTINGS = {
    "cube": ["analytic 1e-3", "analytic 1e-5", "analytic 1e-8"],
    "cornell-regular": ["analytic 1e-2", "analytic 1e-4", "analytic 1e-5"],
    "blocked squares": ["analytic 1e-2", "analytic 1e-4", "analytic 1e-5", "analytic 1e-6"],
}
EVERYWHERE = ["hemicube 1e-2", "sampling 1000 rays", "sampling 10000 rays"]
PIECES = {"cube": [1], "cornell-regular": [1, 2, 3], "blocked squares": [1, 2, 3, 4]}


def measure(results, peers, scenes):
    say("view factors")
    results.note(
        "settings of peers-factors: tolerance; of sampling, rays from a face; of pyviewfactor, "
        "pieces along a face's edge"
    )
    files = {
        "cube": scenes["cube"],
        "cornell-regular": scenes["box"],
        "blocked squares": blocked_squares(SCENES / "blocked" / "squares.obj"),
    }
    output = WORK / "F.npy"
    known = exact.exact_cube(polygons.read(files["cube"]))
    tolerance = 1e-7
    box = files["cornell-regular"]
    ours(f"form-factors {box} -o {output} --method analytic --tolerance {tolerance}")
    best = read_npy(output)

    def error(scene, matrix):
        if scene == "blocked squares":
            return abs(squares_factor(matrix) - QUARTER_HIDDEN)
        if scene == "cube":
            return largest(matrix, known)
        return mean_square([a - b for a, b in zip(matrix, best)])

    uncertainty = {"cube": 1e-13, "cornell-regular": tolerance, "blocked squares": 1e-15}

    def add(scene, method, setting, run):
        count = math.isqrt(len(run["found"][0]))
        results.add(
            "peers-factors",
            scene,
            method,
            setting,
            run["seconds"],
            factors=count * (count - 1) // 2,
            memory=run["memory"],
            error=mean_square([error(scene, found) for found in run["found"]]),
            uncertainty=uncertainty[scene],
        )

    for scene, settings in OUR_SETTINGS.items():
        for setting in settings + EVERYWHERE:
            method, asked, *is_rays = setting.split()
            option = "samples" if is_rays else "tolerance"
            arguments = f"form-factors {files[scene]} --method {method} --{option} {asked}"
            run = ours_timed(arguments, output, read_npy)
            add(scene, f"radiosity {method}", asked, run)

    tasks = [
        {
            "id": f"{scene}/{pieces}",
            "obj": str(files[scene]),
            "pieces": pieces,
            "blockers": scene != "cube",
            "output": str(WORK / f"pyviewfactor-{scene.replace(' ', '-')}-{pieces}.bin"),
        }
        for scene, all_pieces in PIECES.items()
        for pieces in all_pieces
    ]
    job = {"warm": str(scenes["warm"]), "runs": RUNS, "tasks": tasks}
    answers = peers.ask("pyviewfactor", job)
    for task in tasks:
        if task["id"] in answers:
            scene, pieces = task["id"].split("/")
            run = {**answers[task["id"]], "found": [read_raw(task["output"])]}
            add(scene, "pyviewfactor", pieces, run)
