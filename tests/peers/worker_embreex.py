"""Rays against triangles by Embree, through embreex."""

import polygons
import worker

import numpy as np
from embreex import rtcore_scene
from embreex.mesh_construction import TriangleMesh

job = worker.job()
worker.started()
triangles = [t for face in polygons.read(job["obj"]) for t in face.triangles()]
rays = np.fromfile(job["rays"], dtype="<f8").reshape(-1, 7).astype(np.float32)
origins = np.ascontiguousarray(rays[:, 0:3])
directions = np.ascontiguousarray(rays[:, 3:6])
reach = np.ascontiguousarray(rays[:, 6])

start = worker.cpu()
scene = rtcore_scene.EmbreeScene()
mesh = TriangleMesh(scene, np.array(triangles, dtype=np.float32))
tenth = len(rays) // 10
scene.run(origins[:tenth], directions[:tenth])  # builds the hierarchy, and warms up
worker.answer(build=worker.cpu() - start)

seconds, found = worker.timed(job["runs"], lambda _: scene.run(origins, directions))
hits = int(np.count_nonzero(found[-1] >= 0))
worker.answer(id="closest", seconds=seconds, hits=hits, memory=worker.peak())

# `dists` is what a ray may at most run.
seconds, found = worker.timed(
    job["runs"],
    lambda _: scene.run(origins, directions, dists=reach, query="OCCLUDED"),
)
hits = int(np.count_nonzero(found[-1] >= 0))
worker.answer(id="any", seconds=seconds, hits=hits, memory=worker.peak())
