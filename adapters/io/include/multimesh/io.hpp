// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Files as plain lists.
#include "multimesh/io/mesh_reader.hpp"
#include "multimesh/io/obj_reader.hpp"
#include "multimesh/io/obj_writer.hpp"
#include "multimesh/io/polygon_writer.hpp"
#include "multimesh/io/simplex_reader.hpp"
#include "multimesh/io/simplex_writer.hpp"
#include "multimesh/io/triangulate.hpp"
