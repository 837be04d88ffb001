// SPDX-License-Identifier: BSD-3-Clause
// openmesh_decimater IN.obj OUT.obj RATIO [attached]: a whole program around OpenMesh's own decimater, with
// quadrics and no normal turned over. Positions only. What a user of OpenMesh has today; figures.py measures
// it beside ours. `attached`: by our decimate() on the same mesh. Prints the CPU time without reading and
// writing.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <charconv>
#include <ctime>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/domains/attached_embedding.hpp"
#include "test/benchmark/plain_obj.hpp"

namespace multimesh::bench {
namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using TriMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

TriMesh mesh_of(const PlainObj& obj) {
  TriMesh mesh;
  const std::size_t v = obj.positions.size(), f = obj.faces.size();
  mesh.reserve(v, v + f, f);
  for (const auto& p : obj.positions) mesh.add_vertex({p[0], p[1], p[2]});
  const auto vertex = [](std::uint32_t i) { return OpenMesh::VertexHandle(static_cast<int>(i)); };
  for (const auto& [a, b, c] : obj.faces) mesh.add_face(vertex(a), vertex(b), vertex(c));
  return mesh;
}

void decimate_attached(TriMesh& mesh, std::size_t faces) {
  openmesh::Attached attached(mesh);
  DecimateOptions options;
  options.faces = faces;
  (void)multimesh::decimate(embedding(attached), NodeId::root, options);
  attached.garbage_collection();
}

void decimate(TriMesh& mesh, std::size_t faces) {
  mesh.request_face_normals();
  mesh.update_face_normals();
  OpenMesh::Decimater::DecimaterT<TriMesh> decimater(mesh);
  OpenMesh::Decimater::ModQuadricT<TriMesh>::Handle quadric;
  OpenMesh::Decimater::ModNormalFlippingT<TriMesh>::Handle normal_flipping;
  decimater.add(quadric);
  decimater.add(normal_flipping);
  decimater.module(quadric).unset_max_err();
  decimater.initialize();
  decimater.decimate_to_faces(0, faces);
  mesh.garbage_collection();
}

PlainObj obj_of(const TriMesh& mesh) {
  PlainObj obj;
  for (const auto v : mesh.vertices())
    obj.positions.push_back({mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]});
  for (const auto f : mesh.faces()) {
    auto& corners = obj.faces.emplace_back();
    std::size_t k = 0;
    for (const auto v : mesh.fv_range(f)) corners[k++] = static_cast<std::uint32_t>(v.idx());
  }
  return obj;
}

double ratio_of(std::string_view text) {
  double ratio = 0;
  std::from_chars(text.data(), text.data() + text.size(), ratio);
  return ratio;
}

}  // namespace
}  // namespace multimesh::bench

int main(int argc, char** argv) try {
  using namespace multimesh::bench;
  const bool attached = argc == 5 && argv[4] == std::string("attached");
  const double ratio = argc == 4 || attached ? ratio_of(argv[3]) : 0;
  if (ratio <= 0 || ratio > 1) {
    std::cerr << "Usage: openmesh_decimater IN.obj OUT.obj RATIO [attached]\n";
    return 2;
  }
  TriMesh mesh = mesh_of(read_plain_obj(argv[1]));
  const auto faces = static_cast<std::size_t>(ratio * static_cast<double>(mesh.n_faces()));
  const std::clock_t start = std::clock();
  attached ? decimate_attached(mesh, faces) : decimate(mesh, faces);
  std::cout << static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC << " s\n";
  write_plain_obj(argv[2], obj_of(mesh));
} catch (const std::exception& e) {
  std::cerr << "openmesh_decimater: " << e.what() << '\n';
  return 1;
}
