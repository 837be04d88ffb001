#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reads mesh files with meshio and writes them again: through_meshio.py [IN OUT FORMAT]..."""
import sys

import meshio
import numpy

OPTIONS = {  # our names of forms: meshio's format and options
    "gmsh22": ("gmsh22", {"binary": False}),
    "gmsh22-binary": ("gmsh22", {"binary": True}),
    "gmsh": ("gmsh", {"binary": False}),
    "gmsh-binary": ("gmsh", {"binary": True}),
    "medit": ("medit", {}),
    "vtu": ("vtu", {}),
    "vtu-plain": ("vtu", {"compression": None}),
    "vtu-ascii": ("vtu", {"binary": False}),
    "vtk42": ("vtk42", {"binary": False}),
    "vtk42-binary": ("vtk42", {"binary": True}),
    "vtk51": ("vtk51", {"binary": False}),
    "vtk51-binary": ("vtk51", {"binary": True}),
    "stl": ("stl", {"binary": False}),
    "stl-binary": ("stl", {"binary": True}),
    "off": ("off", {}),
    "ply": ("ply", {"binary": False}),
    "ply-binary": ("ply", {"binary": True}),
    "obj": ("obj", {}),
}
TAG_NAMES = ("gmsh:physical", "medit:ref", "tag")


def tags_of(mesh):
    for name in TAG_NAMES:
        if name in mesh.cell_data:
            return [numpy.asarray(block, dtype=numpy.int32) for block in mesh.cell_data[name]]
    return [numpy.zeros(len(block.data), dtype=numpy.int32) for block in mesh.cells]


def tetrahedra_by_tag(cells, tags):
    """What meshio can write as version 4.1: one block per tag, for the first cell's tag counts for a block, and
    no entity that has no point of its own."""
    pairs = [(c.data, t) for c, t in zip(cells, tags) if c.type == "tetra"]
    blocks = [(data[t == tag], t[t == tag]) for data, t in pairs for tag in numpy.unique(t)]
    return [("tetra", data) for data, _ in blocks], [t for _, t in blocks]


def dim_tags(point_count, cells, tags):
    result = numpy.array([[3, tags[0][0]]] * point_count, dtype=numpy.int32)
    for (_, data), t in zip(cells, tags):
        result[data[:, -1], 1] = t
    return result


def convert(source, target, form):
    file_format, options = OPTIONS[form]
    mesh = meshio.read(source)
    tags = tags_of(mesh)
    if file_format in ("stl", "off", "ply", "obj"):
        cells, tags = [c for c in mesh.cells if c.type == "triangle"], None
    else:
        cells = mesh.cells
        if file_format == "gmsh":
            cells, tags = tetrahedra_by_tag(cells, tags)
    data, point_data = {}, {}
    if file_format == "gmsh":
        point_data["gmsh:dim_tags"] = dim_tags(len(mesh.points), cells, tags)
    if tags and file_format.startswith("gmsh"):
        data = {"gmsh:physical": tags, "gmsh:geometrical": tags}
    elif tags:
        data = {"medit:ref" if file_format == "medit" else "tag": tags}
    meshio.write(target, meshio.Mesh(mesh.points, cells, point_data=point_data, cell_data=data), file_format=file_format, **options)


for i in range(1, len(sys.argv), 3):
    convert(*sys.argv[i : i + 3])
