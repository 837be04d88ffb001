// SPDX-License-Identifier: BSD-3-Clause
// bench_decimater FILE..: OpenMesh's DecimaterT with quadrics to a tenth of the faces: alone, with the module
// of a tree with the texture below, and over a mesh that hides its operations. Side by side, CPU time,
// medians.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <ctime>
#include <iostream>
#include <optional>

#include "adapters/openmesh/root_mesh.hpp"
#include "multimesh/io/mesh_reader.hpp"
#include "multimesh/openmesh/mod_multimesh.hpp"
#include "multimesh/validate.hpp"

namespace multimesh::bench {
namespace {

struct Traits : OpenMesh::DefaultTraitsDouble {
  using TexCoord2D = Vec2;
  HalfedgeAttributes(OpenMesh::Attributes::TexCoord2D | OpenMesh::Attributes::PrevHalfedge);
};
using Plain = OpenMesh::TriMesh_ArrayKernelT<Traits>;

template <class Mesh>
void fill(Mesh& mesh, const io::PolygonSoup& soup) {
  for (const auto& p : soup.positions) mesh.add_vertex({p[0], p[1], p[2]});
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    std::vector<OpenMesh::VertexHandle> v;
    for (const auto& c : soup.face(f)) v.emplace_back(c.v);
    const auto face = mesh.add_face(v);
    for (const auto h : mesh.fh_range(face))
      for (const auto& c : soup.face(f))
        if (c.v == mesh.to_vertex_handle(h).idx()) {
          const auto& uv = soup.texcoords[static_cast<std::size_t>(c.vt)];
          mesh.set_texcoord2D(h, Vec2(uv[0], uv[1]));
        }
  }
}

template <class Mesh>
std::size_t mirrored(const Mesh& mesh) {
  std::size_t n = 0;
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge_handle(f);
    const auto a = mesh.texcoord2D(h), b = mesh.texcoord2D(mesh.next_halfedge_handle(h)),
               c = mesh.texcoord2D(mesh.prev_halfedge_handle(h));
    n += (b[0] - a[0]) * (c[1] - a[1]) <= (c[0] - a[0]) * (b[1] - a[1]);
  }
  return n;
}

struct Run {
  double seconds = 0;
  std::size_t collapses = 0, faces = 0, stale = 0, refused = 0, mirrored_before = 0, mirrored_after = 0;
  bool valid = true;
};

enum class Way { alone, module, root_mesh };

template <class Mesh>
Run run(const io::PolygonSoup& soup, Way way) {
  Mesh mesh;
  fill(mesh, soup);
  Run r;
  r.mirrored_before = mirrored(mesh);
  std::optional<openmesh::Attached<Mesh>> attached;
  const std::clock_t start = std::clock();
  if (way != Way::alone) {
    attached.emplace(mesh);
    (void)attached->add_texture();
    attached->forbid_flips();
  }
  if constexpr (!std::is_same_v<Mesh, Plain>) mesh.drive(*attached);
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  typename openmesh::ModMultimeshT<Mesh>::Handle module;
  typename OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  if (way == Way::module) {
    decimater.add(module);
    decimater.module(module).drive(*attached);
  }
  decimater.add(quadric);
  decimater.module(quadric).unset_max_err();
  decimater.initialize();
  r.collapses = decimater.decimate_to_faces(0, mesh.n_faces() / 10);
  if (way == Way::module) r.stale = decimater.module(module).stale();
  attached ? attached->garbage_collection() : mesh.garbage_collection();
  r.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  r.faces = mesh.n_faces();
  r.mirrored_after = mirrored(mesh);
  if (attached) r.valid = validate(attached->tree()).empty();
  return r;
}

void compare(const char* path) {
  const io::PolygonSoup soup = io::read_mesh(path);
  std::vector<Run> runs[3];
  for (int round = 0; round < 5; ++round) {
    runs[0].push_back(run<Plain>(soup, Way::alone));
    runs[1].push_back(run<Plain>(soup, Way::module));
    runs[2].push_back(run<openmesh::RootMesh<Plain>>(soup, Way::root_mesh));
  }
  double alone = 0;
  for (int way = 0; way < 3; ++way) {
    auto& list = runs[way];
    std::sort(list.begin(), list.end(), [](const Run& x, const Run& y) { return x.seconds < y.seconds; });
    const Run& m = list[2];
    if (way == 0) alone = m.seconds;
    std::cout << path
              << (way == 0   ? "  alone     "
                  : way == 1 ? "  module    "
                             : "  root mesh ")
              << m.seconds << " s (" << m.seconds / alone << "x), " << m.collapses << " collapses, "
              << m.faces << " faces left, taken back " << m.stale << ", mirrored " << m.mirrored_before
              << " -> " << m.mirrored_after << (m.valid ? "" : ", INVALID") << '\n';
  }
}

}  // namespace
}  // namespace multimesh::bench

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) multimesh::bench::compare(argv[i]);
}
