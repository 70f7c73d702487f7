"""View-factor matrices by pyviewfactor: contour integrals, one ray between two centres."""

import polygons
import worker

import numpy as np
import pyvista
import pyviewfactor


def mesh_of(outlines):
    points = np.array([p for outline in outlines for p in outline], dtype=np.float64)
    cells, first = [], 0
    for outline in outlines:
        cells += [len(outline), *range(first, first + len(outline))]
        first += len(outline)
    return pyvista.PolyData(points, np.array(cells))


def pieces_of(outline, times):
    """A quadrilateral cut into `times` squared ones; other outlines stay whole."""
    if times == 1 or len(outline) != 4:
        return [outline]
    a = np.array(outline, dtype=np.float64)

    def at(u, v):
        return (1 - u) * ((1 - v) * a[0] + v * a[3]) + u * ((1 - v) * a[1] + v * a[2])

    step = [k / times for k in range(times + 1)]
    return [
        [at(u, v), at(s, v), at(s, t), at(u, t)]
        for u, s in zip(step, step[1:])
        for v, t in zip(step, step[1:])
    ]


def matrix(faces, times, blockers):
    """Row i from face i: pyviewfactor's columns; pieces are summed up to their faces."""
    pieces, owner = [], []
    for i, face in enumerate(faces):
        cut = pieces_of(face.corners, times)
        pieces += cut
        owner += [i] * len(cut)
    mesh = mesh_of(pieces)
    whole = mesh_of([face.corners for face in faces]).triangulate()
    found = pyviewfactor.compute_viewfactor_matrix(
        mesh, obstacles=whole if blockers else None
    )
    found = found.T
    if times == 1:
        return found
    areas = np.array([polygons.normal_and_area(p)[1] for p in pieces])
    of_faces = np.zeros((len(faces), len(pieces)))
    of_faces[owner, np.arange(len(pieces))] = 1.0
    flow = of_faces @ (areas[:, None] * found) @ of_faces.T
    return flow / np.array([face.area for face in faces])[:, None]


job = worker.job()
worker.started()
small = polygons.read(job["warm"])
matrix(small, 2, True)  # compiles all that is used below
worker.answer(warm=worker.cpu())
for task in job["tasks"]:
    faces = polygons.read(task["obj"])
    seconds, found = worker.timed(
        job["runs"],
        lambda run: matrix(faces, task["pieces"], task["blockers"]),
    )
    found[-1].astype("<f8").tofile(task["output"])
    worker.answer(id=task["id"], seconds=seconds, memory=worker.peak())
