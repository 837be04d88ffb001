// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// OpenMesh meshes in trees: attaching what a user has, meshes of our own, the module for its decimater.
#include "multimesh/openmesh/attach.hpp"
#include "multimesh/openmesh/edge_mesh.hpp"
#include "multimesh/openmesh/make_mesh.hpp"
#include "multimesh/openmesh/no_flips.hpp"
#include "multimesh/openmesh/triangle_mesh.hpp"
