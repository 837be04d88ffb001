#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What other programs read in periodic files of second order: second_order_by_peers.py FILE PAIRS...

meshio: nodes lie in the middles of their edges. Gmsh's library, if it is installed, on files of version 4.1:
positive Jacobians; its periodic nodes are those of the table of pairs. Both: copies lie lattice vectors apart."""
import ctypes
import ctypes.util
import sys

import meshio
import numpy

EDGES = {  # in the order of VTK, into which meshio brings all elements
    "line3": [(0, 1)],
    "triangle6": [(0, 1), (1, 2), (2, 0)],
    "tetra10": [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)],
}


def read_pairs(name):
    periods, pairs = {}, []
    for line in open(name):
        if line.startswith("# period "):
            axis, vector = line[9:].split(":")
            periods["xyz".index(axis)] = numpy.array([float(x) for x in vector.split()])
        elif line[0].isdigit():
            pairs.append([int(n) for n in line.split(",")])
    return periods, pairs


def check_copies(name, table, points):
    periods, pairs = table
    for slave, master, *vector in pairs:
        shift = sum(k * periods[axis] for axis, k in enumerate(vector) if k)
        assert numpy.abs(points[slave - 1] - points[master - 1] - shift).max() < 4e-15, (name, slave)


def check_by_meshio(name, table):
    mesh = meshio.read(name)
    found = 0
    for cells in mesh.cells:
        assert cells.type in EDGES or cells.type == "vertex", cells.type
        for i, (a, b) in enumerate(EDGES.get(cells.type, [])):
            middle = cells.data[:, max(max(e) for e in EDGES[cells.type]) + 1 + i]
            ends = mesh.points[cells.data[:, a]], mesh.points[cells.data[:, b]]
            assert (mesh.points[middle] == (ends[0] + ends[1]) / 2).all(), (name, cells.type, a, b)
            found += len(middle)
    assert found > 0, name
    if not name.endswith("41.msh"):  # of which it does not read the numbers of nodes
        check_copies(name, table, mesh.points)


class Gmsh:
    def __init__(self, library):
        self.library = ctypes.CDLL(library)
        self.call("Initialize", 0, None, 1)
        self.call("OptionSetNumber", b"General.Verbosity", ctypes.c_double(1))

    def call(self, name, *arguments):
        error = ctypes.c_int()
        getattr(self.library, "gmsh" + name)(*arguments, ctypes.byref(error))
        assert error.value == 0, name

    def lists(self, name, types, *arguments, more=()):
        out = [(ctypes.POINTER(t)(), ctypes.c_size_t()) for t in types]
        self.call(name, *arguments, *[ctypes.byref(x) for pair in out for x in pair], *more)
        return [[data[i] for i in range(size.value)] for data, size in out]

    def periodic_pairs(self):
        pairs = set()
        for dimension, tag in self.entities():
            master = ctypes.c_int()
            slaves, masters, _ = self.lists(
                "ModelMeshGetPeriodicNodes", [ctypes.c_size_t, ctypes.c_size_t, ctypes.c_double],
                dimension, tag, ctypes.byref(master), more=(1,))
            pairs.update(zip(slaves, masters))
        return pairs

    def entities(self):
        flat = self.lists("ModelGetEntities", [ctypes.c_int], more=(-1,))[0]
        return list(zip(flat[::2], flat[1::2]))

    def points(self):
        tags, coordinates, _ = self.lists(
            "ModelMeshGetNodes", [ctypes.c_size_t, ctypes.c_double, ctypes.c_double], more=(-1, -1, 0, 0))
        points = numpy.empty((len(tags), 3))
        points[numpy.array(tags) - 1] = numpy.array(coordinates).reshape(-1, 3)
        return points

    def least_jacobian(self, element):
        inside = (ctypes.c_double * 6)(0.2, 0.2, 0.2 * (element == 11), 0.1, 0.6, 0.1 * (element == 11))
        double = ctypes.c_double
        _, determinants, _ = self.lists(
            "ModelMeshGetJacobians", [double, double, double], element, inside, ctypes.c_size_t(6),
            more=(-1, ctypes.c_size_t(0), ctypes.c_size_t(1)))
        assert determinants
        return min(determinants)


def classes(pairs):
    """The nodes that are linked by pairs."""
    parent = {}

    def find(node):
        while parent.setdefault(node, node) != node:
            node = parent[node]
        return node

    for a, b in pairs:
        parent[find(a)] = find(b)
    together = {}
    for node in parent:
        together.setdefault(find(node), set()).add(node)
    return sorted(sorted(nodes) for nodes in together.values())


def check_by_gmsh(gmsh, name, table):
    gmsh.call("Clear")
    gmsh.call("Open", name.encode())
    assert classes(gmsh.periodic_pairs()) == classes([p[:2] for p in table[1]]), name
    check_copies(name, table, gmsh.points())
    three = any(dimension == 3 for dimension, _ in gmsh.entities())
    assert gmsh.least_jacobian(11 if three else 9) > 0, name


library = ctypes.util.find_library("gmsh")
gmsh = Gmsh(library) if library else None
for file, pairs in zip(sys.argv[1::2], sys.argv[2::2]):
    table = read_pairs(pairs)
    check_by_meshio(file, table)
    if gmsh and file.endswith("41.msh"):
        check_by_gmsh(gmsh, file, table)
        print("Gmsh agrees on", file)
