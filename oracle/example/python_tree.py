# SPDX-License-Identifier: MIT
"""A light tree in Python: the lights in the order given are the leaves of a binary heap, and its
nodes have bounds. python_tree.c makes a library of it, which says how to run it."""

from ctypes import CFUNCTYPE, POINTER, Structure
from ctypes import c_char_p, c_double, c_float, c_int, c_uint32, c_uint64, c_void_p, sizeof
from math import fsum, hypot, inf, pi, sqrt

Vector = c_float * 3


class Light(Structure):
    _fields_ = [("kind", c_uint32), ("position", Vector), ("intensity", Vector), ("axis", Vector),
                ("cos_inner", c_float), ("cos_outer", c_float)]


class Point(Structure):
    _fields_ = [("position", Vector), ("normal", Vector), ("to_viewer", Vector),
                ("mirror", Vector), ("diffuse", Vector), ("lobe", c_uint32),
                ("reflectance", Vector), ("width", c_float)]


DIRECTIONAL, NONE, PHONG, WARD = 3, 0, 1, 2  # kind; lobes
LIST = CFUNCTYPE(c_uint32, c_void_p, c_uint32, POINTER(c_uint32), c_uint32)


class Subject(Structure):  # what comes after bound() is not offered
    _fields_ = [("abi_version", c_uint32), ("size", c_uint32), ("name", c_char_p),
                ("build", CFUNCTYPE(c_void_p, POINTER(Light), c_uint32, c_float, c_uint64)),
                ("destroy", CFUNCTYPE(None, c_void_p)),
                ("node_count", CFUNCTYPE(c_uint32, c_void_p)),
                ("children", LIST), ("lights", LIST),
                ("representative", c_void_p), ("intensity", c_void_p),
                ("bound", CFUNCTYPE(c_int, c_void_p, c_uint32, POINTER(Point), POINTER(c_float)))]


count, nodes, nearest_distance2 = 0, [], 0.0  # of the tree; there is one at a time


def build(lights, light_count, min_distance, _seed):
    global count, nodes, nearest_distance2
    count, nearest_distance2 = light_count, min_distance**2
    nodes = [None] * (2 * count - 1)
    for i in range(count):
        box, power = [(x, x) for x in lights[i].position], list(lights[i].intensity)
        far = lights[i].kind == DIRECTIONAL
        nodes[count - 1 + i] = ([(inf, -inf)] * 3, [0] * 3, power) if far else (box, power, [0] * 3)
    for i in reversed(range(count - 1)):
        boxes, *powers = zip(nodes[2 * i + 1], nodes[2 * i + 2])
        box = [(min(a, c), max(b, d)) for (a, b), (c, d) in zip(*boxes)]
        nodes[i] = (box, *([a + b for a, b in zip(*both)] for both in powers))
    return 1


def peak(p, cosine, colour):
    """The most that is reflected, f n.l of one colour; cosine is n.v."""
    diffuse, reflectance, a2 = p.diffuse[colour] / pi, p.reflectance[colour], p.width**2
    if p.lobe == PHONG:
        return diffuse + reflectance * (p.width + 2) / (2 * pi)
    if p.lobe == NONE or cosine <= 0:
        return diffuse
    if p.lobe == WARD:
        return diffuse + reflectance / (4 * pi * a2 * sqrt(cosine))
    return diffuse + 1 / (2 * pi * a2 * (sqrt(a2 + (1 - a2) * cosine**2) + cosine))


def bound(_tree, node, point, out):
    p, (box, near, far) = point[0], nodes[node]
    n, v, x = p.normal, p.to_viewer, p.position
    # Products of two floats are exact, and fsum() rounds once, so that the signs are right.
    cosine = fsum(a * b for a, b in zip(n, v)) / (hypot(*n) * hypot(*v))
    corner = [b if a > 0 else c for a, (c, b) in zip(n, box)]
    above = corner[0] not in (inf, -inf) and fsum(
        term for a, b, c in zip(n, corner, x) for term in (a * b, -a * c)) > 0
    d2 = max(sum(max(a - c, c - b, 0)**2 for (a, b), c in zip(box, x)), nearest_distance2)
    for c in range(3):
        most, is_lit = peak(p, cosine, c), above and near[c] > 0
        arriving = far[c] + ((near[c] / d2 if d2 > 0 else inf) if is_lit else 0)
        # More is added than rounding to float takes away.
        out[c] = most * arriving * (1 + 2**-22) + 2**-149 if most > 0 and arriving > 0 else 0
    return 0


def write(indices, out, capacity):
    for i, index in enumerate(indices[:capacity]):
        out[i] = index
    return len(indices)


OFFERED = {
    "build": build, "destroy": lambda tree: None, "node_count": lambda tree: len(nodes),
    "children": lambda tree, i, *out: write([2 * i + 1, 2 * i + 2] if i < count - 1 else [], *out),
    "lights": lambda tree, i, *out: write([i - (count - 1)], *out), "bound": bound}
TYPES = dict(Subject._fields_)
CALLBACKS = {name: TYPES[name](function) for name, function in OFFERED.items()}  # kept alive


def fill(address):
    """Writes the table that python_tree.c exports."""
    Subject.from_address(address).__init__(1, sizeof(Subject), b"python tree", **CALLBACKS)
