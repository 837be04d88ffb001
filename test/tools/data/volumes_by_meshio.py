#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What meshio finds in an MSH file: a line per named group with its number of cells, and the volume of tetrahedra."""
import sys

import meshio
import numpy

mesh = meshio.read(sys.argv[1])
tags = mesh.cell_data["gmsh:physical"]
assert all(len(t) == len(c.data) and (t > 0).all() for c, t in zip(mesh.cells, tags)), "an element without tag"


def lines(kind, dimension):
    cells = numpy.concatenate([c.data for c in mesh.cells if c.type == kind])
    tag = numpy.concatenate([t for c, t in zip(mesh.cells, tags) if c.type == kind])
    names = {t: n for n, (t, d) in mesh.field_data.items() if d == dimension}
    p = mesh.points
    for t in numpy.unique(tag):
        own = cells[tag == t]
        size = 0.0
        if kind == "tetra":
            a, b, c, d = (p[own[:, i]] for i in range(4))
            volumes = numpy.einsum("ij,ij->i", numpy.cross(b - a, c - a), d - a) / 6
            assert (volumes > 0).all(), "a tetrahedron that is not positive"
            size = volumes.sum()
        print(kind, t, len(own), round(float(size), 9), names.get(t, "-"), sep=";")


lines("tetra", 3)
lines("triangle", 2)
