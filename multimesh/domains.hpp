// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What people have, as trees of meshes with their values.
#include "multimesh/domains/attached_embedding.hpp"
#include "multimesh/domains/make_mesh.hpp"
#include "multimesh/domains/periodic_domain.hpp"
#include "multimesh/domains/tet_domain.hpp"
#include "multimesh/domains/textured_surface.hpp"
