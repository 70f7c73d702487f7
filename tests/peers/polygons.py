"""The polygons that all programs are handed: OBJ and MTL files as our command writes them.

Standard library only: every peer's environment imports this.
"""

from pathlib import Path


class Face:
    """One `f` of the file: its corners, and what its material gives and sends back."""

    def __init__(self, corners, material, diffuse, emission):
        self.corners, self.material = corners, material
        self.diffuse, self.emission = diffuse, emission
        self.normal, self.area = normal_and_area(corners)

    def triangles(self):
        a = self.corners
        return [(a[0], a[k], a[k + 1]) for k in range(1, len(a) - 1)]

    def emits(self):
        return max(self.emission) > 0.0


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def normal_and_area(corners):
    total = [0.0, 0.0, 0.0]
    for k in range(1, len(corners) - 1):
        part = cross(sub(corners[k], corners[0]), sub(corners[k + 1], corners[0]))
        total = [x + y for x, y in zip(total, part)]
    length = dot(total, total) ** 0.5
    return [x / length for x in total], 0.5 * length


def read_materials(path):
    materials, name = {}, None
    for line in Path(path).read_text().splitlines():
        words = line.split()
        if words[:1] == ["newmtl"]:
            name = line.split(maxsplit=1)[1]
            materials[name] = {"Kd": [0.0] * 3, "Ke": [0.0] * 3}
        elif words and words[0] in ("Kd", "Ke"):
            materials[name][words[0]] = [float(x) for x in words[1:4]]
    return materials


def read(path):
    """The faces of an OBJ file, in its order."""
    path = Path(path)
    vertices, faces, materials, current = [], [], {}, None
    for line in path.read_text().splitlines():
        words = line.split()
        if not words or words[0].startswith("#"):
            continue
        if words[0] == "v":
            vertices.append([float(x) for x in words[1:4]])
        elif words[0] == "mtllib":
            materials = read_materials(path.parent / words[1])
        elif words[0] == "usemtl":
            current = line.split(maxsplit=1)[1]
        elif words[0] == "f":
            corners = [vertices[int(word) - 1] for word in words[1:]]
            material = materials.get(current, {"Kd": [0.5] * 3, "Ke": [0.0] * 3})
            faces.append(Face(corners, current, material["Kd"], material["Ke"]))
    return faces
