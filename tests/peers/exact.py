"""View factors known in closed form: between the tiles of a cube's walls."""

import array
import math


def parallel(a, b, distance):
    """Factor times area between opposite rectangles (x0, x1, y0, y1): Howell C-13."""

    def g(x, y, p, q):
        u, v, z = x - p, y - q, distance
        s, t = math.hypot(u, z), math.hypot(v, z)
        atans = v * s * math.atan(v / s) + u * t * math.atan(u / t)
        return (atans - 0.5 * z * z * math.log(u * u + v * v + z * z)) / (2 * math.pi)

    return signed_sum(g, a, b)


def perpendicular(a, b):
    """Between rectangles in two planes at right angles: Howell C-14.

    Each is (x0, x1, y0, y1): x from the line where the planes meet, y along it.
    """

    def g(x, y, p, q):
        w, v = x * x + p * p, y - q
        atan = v * math.sqrt(w) * math.atan(v / math.sqrt(w)) if w > 0 else 0.0
        log = 0.25 * (w - v * v) * math.log(w + v * v) if w + v * v > 0 else 0.0
        return (atan - log) / (2 * math.pi)

    return signed_sum(g, a, b)


def signed_sum(g, a, b):
    terms = [
        (-1) ** (i + j + k + l) * g(a[i], a[2 + j], b[k], b[2 + l])
        for i in range(2)
        for j in range(2)
        for k in range(2)
        for l in range(2)
    ]
    return abs(math.fsum(terms))


def exact_cube(faces):
    """The factors between axis-aligned rectangles on the walls of the unit cube."""

    def box(face):
        return [
            (min(p[k] for p in face.corners), max(p[k] for p in face.corners))
            for k in range(3)
        ]

    boxes = [box(face) for face in faces]
    flat = [next(k for k in range(3) if b[k][1] - b[k][0] < 1e-12) for b in boxes]
    matrix = array.array("d")
    for i, a in enumerate(boxes):
        for j, b in enumerate(boxes):
            m, n = flat[i], flat[j]
            if m == n:
                distance = abs(a[m][0] - b[m][0])
                u, v = [k for k in range(3) if k != m]
                flow = (
                    parallel(a[u] + a[v], b[u] + b[v], distance) if distance > 0.5 else 0.0
                )
            else:
                along = 3 - m - n
                # How far from the other's plane.
                far_a = tuple(sorted(abs(x - b[n][0]) for x in a[n]))
                far_b = tuple(sorted(abs(x - a[m][0]) for x in b[m]))
                flow = perpendicular(far_a + a[along], far_b + b[along])
            matrix.append(flow / faces[i].area)
    return matrix
