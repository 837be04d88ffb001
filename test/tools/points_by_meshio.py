#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Points that a Gmsh file lists are in another one, too, with tags and names: points_by_meshio.py BEFORE AFTER"""
import sys

import meshio


def listed(name):
    mesh = meshio.read(name)
    points = set()
    for cells, tags in zip(mesh.cells, mesh.cell_data["gmsh:physical"]):
        if cells.type == "vertex":
            points |= {(*mesh.points[v], int(tag)) for (v,), tag in zip(cells.data, tags)}
    names = {name: tag for name, (tag, dimension) in mesh.field_data.items() if dimension == 0}
    return points, names


before, after = listed(sys.argv[1]), listed(sys.argv[2])
assert before[0], "nothing is listed"
assert before == after, (before, after)
