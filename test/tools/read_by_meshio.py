#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reads mesh files with meshio; every cell must have a positive physical tag: read_by_meshio.py FILE..."""
import sys

import meshio

for name in sys.argv[1:]:
    mesh = meshio.read(name)
    tags = mesh.cell_data["gmsh:physical"]
    assert len(tags) == len(mesh.cells), name
    for cells, block in zip(mesh.cells, tags):
        assert len(block) == len(cells.data) and (len(block) == 0 or block.min() > 0), name
