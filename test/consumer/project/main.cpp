// SPDX-License-Identifier: BSD-3-Clause
// A project that uses all of our libraries: core, openmesh, io, algorithms, files, spatial, compare and
// remesh.
#include <cstdio>
#include <exception>

#include "multimesh/algorithms/compare.hpp"
#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/algorithms/remesh.hpp"
#include "multimesh/files/surface_file.hpp"
#include "multimesh/io/obj_reader.hpp"
#include "multimesh/openmesh/connectivity.hpp"
#include "multimesh/validate.hpp"
#include "multimesh/version.hpp"

// Four triangles around a vertex, the texture cut open on two of the edges there.
constexpr const char* square =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt .5 .5\nvt 2 0\nvt 3 0\nvt 3 1\nvt 2.5 .5\n"
    "f 1/1 2/2 5/5\nf 4/4 1/1 5/5\nf 2/7 3/8 5/9\nf 3/3 4/4 5/5\n";

int main() try {
  using namespace multimesh;
  const TexturedTriangles input = files::to_surface(io::parse_obj(square, "square.obj"), "square.obj").input;
  TexturedSurface surface(input);
  const DecimateResult result = decimate(surface, {.faces = 1});
  const auto& root = dynamic_cast<const openmesh::Connectivity&>(surface.tree().mesh(NodeId::root));
  std::printf("multimesh %s: %zu faces -> %zu of %zu in OpenMesh's arrays\n", version, result.faces_before,
              result.faces_after, root.openmesh().n_faces());
  TexturedSurface even(input);
  RemeshOptions options;
  options.length = 0.2;
  const RemeshResult remeshed = remesh(even, options);
  const SurfaceComparison comparison = compare_surfaces(input, input, {.samples = 100});
  return validate(surface.tree()).empty() && validate(even.tree()).empty() && remeshed.splits > 0 &&
                 result.faces_before == 4 && comparison.hausdorff < 1e-12
             ? 0
             : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
