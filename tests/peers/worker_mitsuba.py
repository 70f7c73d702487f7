"""Irradiance of patches, and rays, by Mitsuba 3 in its variant `llvm_ad_rgb`."""

import polygons
import worker

import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")
import drjit as dr  # noqa: E402, after the variant

dr.set_thread_count(1)


def mesh(name, faces):
    """All faces of one material."""
    corners = [p for face in faces for t in face.triangles() for p in t]
    properties = mi.Properties()
    bsdf = {"type": "diffuse", "reflectance": {"type": "rgb", "value": faces[0].diffuse}}
    properties["bsdf"] = mi.load_dict(bsdf)
    if faces[0].emits():
        radiance = [e / np.pi for e in faces[0].emission]
        light = {"type": "area", "radiance": {"type": "rgb", "value": radiance}}
        properties["emitter"] = mi.load_dict(light)
    made = mi.Mesh(name, len(corners), len(corners) // 3, props=properties)
    values = mi.traverse(made)
    values["vertex_positions"] = np.array(corners, dtype=np.float32).ravel()
    values["faces"] = np.arange(len(corners), dtype=np.uint32)
    values.update()
    return made


def scene_of(faces):
    names = dict.fromkeys(face.material for face in faces)
    meshes = {
        f"mesh{k}": mesh(f"mesh{k}", [f for f in faces if f.material == name])
        for k, name in enumerate(names)
    }
    return mi.load_dict({"type": "scene", **meshes})


class Patches:
    """Random points on patches, `samples` on each, and the light that falls on them."""

    def __init__(self, faces):
        self.faces = faces
        self.scene = scene_of(faces)
        triangles = [(k, t) for k, face in enumerate(faces) for t in face.triangles()]
        owner = np.array([k for k, _ in triangles])
        corners = np.array([t for _, t in triangles], dtype=np.float64)
        areas = np.array([polygons.normal_and_area(t)[1] for _, t in triangles])
        self.corners = corners
        self.first = np.searchsorted(owner, np.arange(len(faces)))
        # The share of its patch up to and with each triangle.
        total = np.array([face.area for face in faces])
        running = np.cumsum(areas)
        before = (running - areas)[self.first]
        self.share = (running - before[owner]) / total[owner]
        self.count = np.bincount(owner)
        self.normals = np.array([face.normal for face in faces])
        self.diffuse = np.array([face.diffuse for face in faces])
        size = np.ptp(corners.reshape(-1, 3), axis=0).max()
        self.away = 1e-5 * size  # beyond what single precision confuses
        self.path = mi.load_dict({"type": "path", "max_depth": -1, "rr_depth": 5})

    def points(self, samples, random):
        """Jittered on a grid over each patch, single precision."""
        n = len(self.faces)
        side = int(samples**0.5)
        assert side * side == samples, "samples are a square"
        cell = np.arange(samples)
        u = (cell % side + random.random((n, samples))) / side
        v = (cell // side + random.random((n, samples))) / side
        chosen = np.repeat(self.first[:, None], samples, axis=1)
        start = np.zeros_like(u)
        for _ in range(self.count.max() - 1):
            beyond = u > self.share[chosen]
            start = np.where(beyond, self.share[chosen], start)
            chosen = np.where(beyond, chosen + 1, chosen)
        s = np.sqrt(np.clip((u - start) / (self.share[chosen] - start), 0, 1))[..., None]
        a, b, c = (self.corners[chosen, k] for k in range(3))
        v = v[..., None]
        return ((1 - s) * a + s * ((1 - v) * b + v * c)).reshape(-1, 3)

    def means(self, method, samples, seed):
        """Irradiance of each patch, W/m²."""
        random = np.random.default_rng(seed)
        at = self.points(samples, random)
        normal = np.repeat(self.normals, samples, axis=0)
        sampler = mi.load_dict({"type": "independent"})
        sampler.seed(seed, len(at))
        if method == "radiance":
            # Looks at the patch from close by: B = π L, and H = (B − E) / ρ.
            origin, direction = at + self.away * normal, -normal
        else:
            # A meter: where do cosine-weighted directions lead? H = π L.
            r, phi = np.sqrt(random.random(len(at))), 2 * np.pi * random.random(len(at))
            other = np.where(np.abs(normal[:, :1]) > 0.5, [[0, 1.0, 0]], [[1.0, 0, 0]])
            x = np.cross(normal, other)
            x /= np.linalg.norm(x, axis=1)[:, None]
            y = np.cross(normal, x)
            direction = (r * np.cos(phi))[:, None] * x + (r * np.sin(phi))[:, None] * y
            direction += np.sqrt(1 - r**2)[:, None] * normal
            origin = at + self.away * normal
        ray = mi.RayDifferential3f(
            mi.Point3f(np.ascontiguousarray(origin.T, dtype=np.float32)),
            mi.Vector3f(np.ascontiguousarray(direction.T, dtype=np.float32)),
        )
        light, _, _ = self.path.sample(self.scene, sampler, ray)
        found = np.pi * np.array(light).T.reshape(len(self.faces), samples, 3)
        if method == "radiance":
            emission = np.array([face.emission for face in self.faces])
            diffuse = np.maximum(self.diffuse, 1e-9)  # of the lamp, 0: not asked for
            found = (found - emission[:, None, :]) / diffuse[:, None, :]
        return found.mean(axis=1)


def irradiance(job):
    faces = polygons.read(job["obj"])
    patches = Patches(faces)
    for method in ("radiance", "meter"):
        patches.means(method, 16, 999)  # compiles
    worker.answer(warm=worker.cpu())
    for task in job["tasks"]:
        method, samples = task["method"], task["samples"]

        def run(seed):
            # Building the scene is part of it, as for us; the compiled code is kept.
            patches, rounds = Patches(faces), task["rounds"]
            found = [
                patches.means(method, samples, seed * rounds + k) for k in range(rounds)
            ]
            return np.mean(found, axis=0).tolist()

        seconds, found = worker.timed(job["runs"], run)
        worker.answer(
            id=task["id"], seconds=seconds, memory=worker.peak(), irradiance=found
        )


def reference(job):
    """Many rounds with new random numbers: means and their standard errors."""
    patches = Patches(polygons.read(job["obj"]))
    rounds = []
    for seed in range(job["rounds"]):
        rounds.append(patches.means("radiance", job["samples"], 10_000 + seed))
    rounds = np.array(rounds)
    error = rounds.std(axis=0, ddof=1) / len(rounds) ** 0.5
    worker.answer(
        id="reference", irradiance=rounds.mean(axis=0).tolist(), error=error.tolist()
    )


def rays(job):
    faces = polygons.read(job["obj"])
    data = np.fromfile(job["rays"], dtype="<f8").reshape(-1, 7).astype(np.float32).T
    data = np.ascontiguousarray(data)
    start = worker.cpu()
    scene = scene_of(faces)
    worker.answer(build=worker.cpu() - start)

    def batch(count, reach):
        ray = mi.Ray3f(mi.Point3f(data[0:3, :count]), mi.Vector3f(data[3:6, :count]))
        if reach:
            ray.maxt = mi.Float(data[6, :count])
        return ray

    def closest(count):
        found = scene.ray_intersect_preliminary(batch(count, False))
        return int(np.count_nonzero(np.array(found.is_valid())))

    def within(count):
        return int(np.count_nonzero(np.array(scene.ray_test(batch(count, True)))))

    count = data.shape[1]
    for name, work in (("closest", closest), ("any", within)):
        work(count // 10)
        seconds, hits = worker.timed(job["runs"], lambda _: work(count))
        worker.answer(id=name, seconds=seconds, hits=hits[-1], memory=worker.peak())


job = worker.job()
worker.started()
{"irradiance": irradiance, "reference": reference, "rays": rays}[job["what"]](job)
