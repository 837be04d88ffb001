// SPDX-License-Identifier: BSD-3-Clause
// A user's own OpenMesh mesh, with float points and properties of its own, is decimated in place by quadrics
// of shape and texture together. Everything that it carries goes along.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <algorithm>
#include <iostream>
#include <string>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/domains/attached_embedding.hpp"
#include "multimesh/io/mesh_reader.hpp"
#include "multimesh/validate.hpp"

using namespace multimesh;

struct Traits : OpenMesh::DefaultTraits {  // whatever the pipeline has
  HalfedgeAttributes(OpenMesh::Attributes::TexCoord2D);
};
using UserMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

UserMesh read(const char* path) {
  const io::PolygonSoup soup = io::read_mesh(path);
  UserMesh mesh;
  for (const auto& p : soup.positions) mesh.add_vertex({float(p[0]), float(p[1]), float(p[2])});
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    const auto corner = soup.face(f);
    std::vector<OpenMesh::VertexHandle> v;
    for (const auto& c : corner) v.emplace_back(c.v);
    const auto face = mesh.add_face(v);
    for (const auto h : mesh.fh_range(face))
      for (const auto& c : corner)
        if (c.v == mesh.to_vertex_handle(h).idx()) {
          const auto& uv = soup.texcoords[std::size_t(c.vt)];
          mesh.set_texcoord2D(h, {float(uv[0]), float(uv[1])});
        }
  }
  return mesh;
}

int main(int, char** arguments) {
  UserMesh mesh = read(arguments[1]);
  OpenMesh::VProp<double> height(mesh, "height");  // values of the user's, of any type
  OpenMesh::FProp<std::string> material(mesh, "material");
  OpenMesh::EProp<bool> border(mesh, "border");
  for (const auto v : mesh.vertices()) height[v] = double(mesh.point(v)[1]);
  for (const auto f : mesh.faces()) material[f] = mesh.calc_face_centroid(f)[1] < 0 ? "grass" : "cow";
  const auto is_border = [&](OpenMesh::SmartEdgeHandle e) {
    return !e.is_boundary() && material[e.h0().face()] != material[e.h1().face()];
  };
  for (const auto e : mesh.edges()) border[e] = is_border(e);

  DecimateOptions options;
  options.faces = mesh.n_faces() / 10;
  DecimateResult result;
  {
    openmesh::Attached attached(mesh);
    attached.add_texture();
    attached.add_borders(material);
    attached.follow(height);
    result = decimate(embedding(attached), NodeId::root, options);
    if (!validate(attached.tree()).empty()) return 1;
    attached.garbage_collection();
  }

  // The mesh is an ordinary one again, and knows the same things about what is left of it.
  double wrong = 0;
  for (const auto v : mesh.vertices())
    wrong = std::max(wrong, std::abs(height[v] - double(mesh.point(v)[1])));
  const bool borders_are_known =
      std::ranges::all_of(mesh.edges(), [&](const auto e) { return border[e] == is_border(e); });
  std::cout << result.faces_before << " faces -> " << mesh.n_faces() << "; " << result.charts
            << " charts; heights are off by at most " << wrong << '\n';
  return mesh.n_faces() <= options.faces && borders_are_known && wrong < 0.1 ? 0 : 1;
}
