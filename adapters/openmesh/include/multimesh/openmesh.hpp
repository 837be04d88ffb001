// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// OpenMesh meshes in trees: attaching a user's mesh, meshes of our own, the module for OpenMesh's decimaters.
#include "multimesh/openmesh/attach.hpp"
#include "multimesh/openmesh/edge_mesh.hpp"
#include "multimesh/openmesh/make_mesh.hpp"
#include "multimesh/openmesh/triangle_mesh.hpp"
