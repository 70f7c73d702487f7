"""Irradiance of patches by Radiance's `rtrace -I`, through pyradiance."""

import tempfile
from pathlib import Path

import polygons
import worker

import numpy as np
import pyradiance


def primitives(faces):
    lines, known = [], {}
    for k, face in enumerate(faces):
        if face.material not in known:
            known[face.material] = f"m{len(known)}"
            name = known[face.material]
            if face.emits():
                numbers = [e / 3.141592653589793 for e in face.emission]
                lines.append(f"void light {name} 0 0 3 " + " ".join(map(repr, numbers)))
            else:
                numbers = " ".join(map(repr, face.diffuse))
                lines.append(f"void plastic {name} 0 0 5 {numbers} 0 0")
        numbers = [x for p in face.corners for x in p]
        lines.append(
            f"{known[face.material]} polygon p{k} 0 0 {len(numbers)} "
            + " ".join(map(repr, numbers))
        )
    return "\n".join(lines) + "\n"


def points_on(face, count, turn):
    """Points spread evenly over a face: Roberts' R2, begun elsewhere each `turn`."""
    triangles = np.array(face.triangles())
    areas = np.array([polygons.normal_and_area(t)[1] for t in triangles])
    k = np.arange(count)
    u = (0.5 + 0.6180339887498949 * turn + 0.7548776662466927 * k) % 1.0
    v = (0.5 + 0.4142135623730951 * turn + 0.5698402909980532 * k) % 1.0
    ends = np.cumsum(areas) / areas.sum()
    chosen = np.minimum(np.searchsorted(ends, u), len(areas) - 1)
    begin = np.concatenate([[0.0], ends[:-1]])[chosen]
    s = np.sqrt((u - begin) / (ends[chosen] - begin))[:, None]
    v = v[:, None]
    a, b, c = (triangles[chosen, corner] for corner in range(3))
    return (1 - s) * a + s * ((1 - v) * b + v * c)


def irradiance(faces, points, params, seed):
    """The mean over `points` points of each face."""
    with tempfile.TemporaryDirectory() as folder:
        text = Path(folder) / "scene.rad"
        text.write_text(primitives(faces))
        octree = Path(folder) / "scene.oct"
        octree.write_bytes(pyradiance.oconv(str(text)))
        rays = np.empty((len(faces), points, 6), dtype="<f4")
        for k, face in enumerate(faces):
            rays[k, :, :3] = points_on(face, points, k + 1000 * seed)
            rays[k, :, 3:] = face.normal
        arguments = dict(header=False, inform="f", outform="f", irradiance=True, nproc=1)
        found = pyradiance.rtrace(rays.tobytes(), octree, params=params, **arguments)
    found = np.frombuffer(found, dtype="<f4").reshape(len(faces), points, 3)
    return found.mean(axis=1, dtype=np.float64).tolist()


job = worker.job()
worker.started()
faces = polygons.read(job["obj"])
irradiance(faces[:30], 1, ["-ab", "1", "-ad", "4"], 0)
worker.answer(warm=worker.cpu())
for task in job["tasks"]:
    seconds, found = worker.timed(
        job["runs"],
        lambda run: irradiance(faces, task["points"], task["params"].split(), run),
    )
    worker.answer(id=task["id"], seconds=seconds, memory=worker.peak(), irradiance=found)
