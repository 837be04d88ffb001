// SPDX-License-Identifier: BSD-3-Clause
// OpenMesh's own decimater, with its quadrics and a module of ours: whatever it does to the mesh is also done
// to the mesh's texture and to the curves along its seams, or not at all.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <iostream>

#include "multimesh/io/mesh_reader.hpp"
#include "multimesh/openmesh/attach.hpp"
#include "multimesh/openmesh/mod_multimesh.hpp"
#include "multimesh/validate.hpp"

using namespace multimesh;

struct Traits : OpenMesh::DefaultTraitsDouble {
  using TexCoord2D = OpenMesh::Vec2d;
  HalfedgeAttributes(OpenMesh::Attributes::TexCoord2D | OpenMesh::Attributes::PrevHalfedge);
};
using UserMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

UserMesh read(const char* path) {
  const io::PolygonSoup soup = io::read_mesh(path);
  UserMesh mesh;
  for (const auto& p : soup.positions) mesh.add_vertex({p[0], p[1], p[2]});
  for (std::size_t f = 0; f + 1 < soup.face_begin.size(); ++f) {
    const auto* corner = &soup.corners[soup.face_begin[f]];
    std::vector<OpenMesh::VertexHandle> v;
    for (int i = 0; i < 3; ++i) v.emplace_back(static_cast<int>(corner[i].v));
    const auto face = mesh.add_face(v);
    for (const auto h : mesh.fh_range(face))
      for (int i = 0; i < 3; ++i)
        if (v[std::size_t(i)] == mesh.to_vertex_handle(h)) {
          const auto& uv = soup.texcoords[std::size_t(corner[i].vt)];
          mesh.set_texcoord2D(h, {uv[0], uv[1]});
        }
  }
  return mesh;
}

std::size_t mirrored_triangles(const UserMesh& mesh) {
  std::size_t mirrored = 0;
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge_handle(f);
    const auto a = mesh.texcoord2D(h), b = mesh.texcoord2D(mesh.next_halfedge_handle(h)),
               c = mesh.texcoord2D(mesh.prev_halfedge_handle(h));
    mirrored += (b[0] - a[0]) * (c[1] - a[1]) < (c[0] - a[0]) * (b[1] - a[1]);
  }
  return mirrored;
}

int main(int, char** arguments) {
  UserMesh mesh = read(arguments[1]);
  const std::size_t faces = mesh.n_faces(), mirrored = mirrored_triangles(mesh);

  openmesh::Attached attached(mesh);
  const NodeId texture = attached.add_texture();
  attached.forbid_flips();
  const MultiMesh& tree = attached.tree();
  const auto is_seam = [&](OpenMesh::EdgeHandle e) {
    DartBuffer sides;
    tree.to_child(texture, attached.dart(e), 1, sides);
    return sides.size() > 1;
  };
  const NodeId seams = attached.add_edges(is_seam);
  const std::size_t seam_edges = tree.mesh(seams).capacity(1);

  OpenMesh::Decimater::DecimaterT<UserMesh> decimater(mesh);
  openmesh::ModMultimeshT<UserMesh>::Handle module;
  OpenMesh::Decimater::ModQuadricT<UserMesh>::Handle quadric;
  decimater.add(module);
  decimater.add(quadric);
  decimater.module(module).drive(attached);
  decimater.initialize();
  decimater.decimate_to_faces(0, faces / 5);
  const std::size_t stale = decimater.module(module).stale();
  attached.garbage_collection();

  std::cout << faces << " faces -> " << mesh.n_faces() << ", seam edges " << seam_edges << " -> "
            << tree.mesh(seams).capacity(1) << "; taken back: " << stale << '\n';
  const bool ok = validate(tree).empty() && mesh.n_faces() <= faces / 5 + 2 * stale &&
                  tree.mesh(texture).capacity(2) == mesh.n_faces() && mirrored_triangles(mesh) <= mirrored;
  return ok ? 0 : 1;
}
