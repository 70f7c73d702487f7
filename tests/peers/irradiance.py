"""Irradiance of patches in the Cornell box: ours, Mitsuba's and Radiance's."""

import math
from pathlib import Path

import polygons
from programs import HERE, RUNS, WORK, ours_timed, say, version
from record import mean_square

#: Longest edge of an element of the box, scene units.
EDGE = 1.1

OUR_SETTINGS = {
    "auto": [0.3, 0.1, 0.05, 0.02, 0.01],
    "hierarchy": [0.3, 0.1, 0.05, 0.03],
    "shoot+hemicube": [0.3, 0.1, 0.03],
    "gather+analytic": [0.3, 0.1, 0.03],
}
MITSUBA_SETTINGS = [
    ("radiance", 16, 1), ("radiance", 64, 1), ("radiance", 256, 1), ("radiance", 1024, 1),
    ("radiance", 4096, 1), ("radiance", 4096, 4), ("radiance", 4096, 16),
    ("meter", 256, 1), ("meter", 4096, 1), ("meter", 4096, 4),
]  # fmt: skip
#: Without a cache, one ambient ray at each bounce or four; and with one, as for pictures.
UNCACHED = "-ab 12 -aa 0 -as 0 -lr -12 -ds 0 -dj 1"
RADIANCE_PARAMETERS = {
    "paths": f"{UNCACHED} -ad 1 -lw 1e-6",
    "branching": f"{UNCACHED} -ad 4 -lw 1e-2",
    "cache": "-ab 3 -aa .3 -ar 32 -ad 256 -as 0",
    "fine cache": "-ab 5 -aa .3 -ar 32 -ad 512 -as 0",
}
RADIANCE_POINTS = {
    "paths": [16, 64, 256, 1024, 4096],
    "branching": [16, 64],
    "cache": [4, 64],
    "fine cache": [64],
}


def read_solution(path):
    rows = Path(path).read_text().splitlines()[1:]
    return [[float(x) for x in row.split(",")[5:8]] for row in rows]


class Reference:
    """Irradiance of each element, and its standard error, as measured beforehand."""

    def __init__(self, faces):
        lines = (HERE / "reference.csv").read_text().splitlines()
        self.about = [line[2:] for line in lines if line.startswith("# ")]
        numbers = [
            [float(x) for x in line.split(",")[1:]]
            for line in lines
            if line and line[0].isdigit()
        ]
        if len(numbers) != len(faces):
            raise SystemExit(
                "reference.csv is of other elements; run.py --reference makes it anew"
            )
        self.faces = faces
        self.groups = {"elements": [[k] for k in range(len(faces))], "faces": self.walls()}
        self.expected = [row[:3] for row in numbers]
        self.spread = [row[3:] for row in numbers]

    def walls(self):
        """Elements of one material in one plane, looking the same way."""
        groups = {}
        for k, face in enumerate(self.faces):
            plane = [*face.normal, polygons.dot(face.normal, face.corners[0])]
            key = (face.material, *(round(x, 6) + 0.0 for x in plane))
            groups.setdefault(key, []).append(k)
        return list(groups.values())

    def means(self, kind, values):
        for group in self.groups[kind]:
            if not self.faces[group[0]].emits():
                area = sum(self.faces[k].area for k in group)
                sums = [
                    sum(self.faces[k].area * values[k][c] for k in group) for c in range(3)
                ]
                yield area, [s / area for s in sums]

    def norm(self, kind, values):
        return sum(
            area * polygons.dot(mean, mean) for area, mean in self.means(kind, values)
        )

    def error(self, kind, values):
        """Root mean square over area and channels, relative to that of the truth."""
        off = [polygons.sub(a, b) for a, b in zip(values, self.expected)]
        return math.sqrt(self.norm(kind, off) / self.norm(kind, self.expected))

    def uncertainty(self, kind):
        """The same norm of what chance leaves open."""
        square = 0.0
        for group in self.groups[kind]:
            if not self.faces[group[0]].emits():
                area = sum(self.faces[k].area for k in group)
                terms = [
                    self.faces[k].area ** 2 * s * s for k in group for s in self.spread[k]
                ]
                square += sum(terms) / area
        return math.sqrt(square / self.norm(kind, self.expected))


def measure(results, peers, scenes):
    say("irradiance")
    faces = polygons.read(scenes["box"])
    reference = Reference(faces)
    for line in reference.about:
        results.note(f"reference of peers-irradiance: {line}")
    results.note(
        "settings of peers-irradiance: tolerance; of mitsuba, paths from an element; of "
        "pyradiance, points on an element"
    )
    for name, params in RADIANCE_PARAMETERS.items():
        results.note(f"pyradiance {name}: rtrace -I {params}")

    def add(method, setting, run, **counts):
        for kind in ("elements", "faces"):
            results.add(
                "peers-irradiance",
                f"cornell-regular {kind}",
                method,
                setting,
                run["seconds"],
                memory=run["memory"],
                error=mean_square([reference.error(kind, h) for h in run["irradiance"]]),
                uncertainty=reference.uncertainty(kind),
                **counts,
            )

    for method, tolerances in OUR_SETTINGS.items():
        solver, *factors_by = method.split("+")
        options = f"--method {solver}"
        options += "".join(f" --form-factors {name}" for name in factors_by)
        for tolerance in tolerances:
            arguments = f"solve {scenes['box']} {options} --tolerance {tolerance}"
            run = ours_timed(arguments, WORK / "solution.csv", read_solution)
            add(f"radiosity {method}", tolerance, {**run, "irradiance": run["found"]})

    tasks = [
        {"id": str(k), "method": method, "samples": samples, "rounds": rounds}
        for k, (method, samples, rounds) in enumerate(MITSUBA_SETTINGS)
    ]
    job = {"what": "irradiance", "obj": str(scenes["box"]), "runs": RUNS, "tasks": tasks}
    answers = peers.ask("mitsuba", job)
    for task in tasks:
        if task["id"] in answers:
            samples = task["samples"] * task["rounds"]
            add(
                f"mitsuba {task['method']}",
                samples,
                answers[task["id"]],
                rays=samples * len(faces),
            )

    tasks = [
        {"id": f"{name}/{points}", "params": params, "points": points}
        for name, params in RADIANCE_PARAMETERS.items()
        for points in RADIANCE_POINTS[name]
    ]
    job = {"obj": str(scenes["box"]), "runs": RUNS, "tasks": tasks}
    answers = peers.ask("pyradiance", job)
    for task in tasks:
        if task["id"] in answers:
            name, points = task["id"].split("/")
            add(f"pyradiance {name}", points, answers[task["id"]])


def make_reference(peers, scenes, rounds, samples=4096):
    faces = polygons.read(scenes["box"])
    job = {
        "what": "reference",
        "obj": str(scenes["box"]),
        "rounds": rounds,
        "samples": samples,
    }
    found = peers.ask("mitsuba", job).get("reference")
    if not found:
        raise SystemExit("without mitsuba there is no reference")
    write_reference(faces, found, rounds, samples)


def write_reference(faces, found, rounds, samples):
    lines = [
        f"# irradiance of the {len(faces)} elements of cornell-regular at --edge {EDGE}, W/m²",
        f"# by unbiased paths of Mitsuba {version('mitsuba')}: {rounds} rounds of {samples} from "
        "each element; standard errors from the spread of the rounds",
        "element,H_r,H_g,H_b,s_r,s_g,s_b",
    ]
    for k, (mean, error) in enumerate(zip(found["irradiance"], found["error"])):
        lines.append(f"{k}," + ",".join(f"{x:.9g}" for x in [*mean, *error]))
    (HERE / "reference.csv").write_text("\n".join(lines) + "\n")
