// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/worker/run_tetgen.hpp"

#include <algorithm>
#include <span>

#include "adapters/tetgen/file_descriptor.hpp"
#include "adapters/tetgen/tetgen_header.hpp"
#include "adapters/tetgen/worker/failure.hpp"

namespace multimesh::tetgen::worker {

namespace {

/// TetGen's input. Markers are the triangles' numbers + 1, 0 being TetGen's for none.
void fill(::tetgenio& in, const Request& request) {
  in.numberofpoints = static_cast<int>(request.points.size());
  in.pointlist = new REAL[request.points.size() * 3];
  for (std::size_t i = 0; i < request.points.size(); ++i)
    std::copy_n(request.points[i].data(), 3, in.pointlist + 3 * i);

  in.numberoffacets = static_cast<int>(request.triangles.size());
  in.facetlist = new ::tetgenio::facet[request.triangles.size()];
  in.facetmarkerlist = new int[request.triangles.size()];
  for (std::size_t t = 0; t < request.triangles.size(); ++t) {
    ::tetgenio::facet& facet = in.facetlist[t];
    ::tetgenio::init(&facet);
    facet.numberofpolygons = 1;
    facet.polygonlist = new ::tetgenio::polygon[1];
    facet.polygonlist[0].numberofvertices = 3;
    facet.polygonlist[0].vertexlist = new int[3];
    for (std::size_t k = 0; k < 3; ++k)
      facet.polygonlist[0].vertexlist[k] = static_cast<int>(request.triangles[t][k]);
    in.facetmarkerlist[t] = static_cast<int>(t) + 1;
  }

  in.numberofholes = static_cast<int>(request.holes.size());
  in.holelist = new REAL[request.holes.size() * 3];
  for (std::size_t i = 0; i < request.holes.size(); ++i)
    std::copy_n(request.holes[i].data(), 3, in.holelist + 3 * i);
}

/// Turns tetrahedra round that are negative. TetGen's predicate is exact; it is below 0 for what we call
/// positive.
void orient(::tetgenio& out) {
  std::int64_t flat = 0;
  for (int t = 0; t < out.numberoftetrahedra; ++t) {
    int* corners = out.tetrahedronlist + 4 * std::ptrdiff_t{t};
    const auto at = [&](int k) { return out.pointlist + 3 * std::ptrdiff_t{corners[k]}; };
    const double side = ::orient3d(at(0), at(1), at(2), at(3));
    if (side == 0) ++flat;
    if (side > 0) std::swap(corners[0], corners[1]);
  }
  if (flat > 0) fail(Outcome::not_positive, flat);
}

/// Writes arrays one behind the other, and the header last.
class ReplyWriter {
 public:
  void add(const void* data, std::size_t size) {
    if (!write_at(reply_file, data, size, offset_)) fail(Outcome::out_of_memory);
    offset_ += size;
  }
  void finish(const ReplyHeader& header) {
    if (!write_at(reply_file, &header, sizeof header, 0)) fail(Outcome::out_of_memory);
  }

 private:
  std::uint64_t offset_ = sizeof(ReplyHeader);
};

}  // namespace

void tetrahedralize(Request& request) {
  ::tetgenio in, out;
  fill(in, request);
  ::tetrahedralize(request.header.switches, &in, &out);
  orient(out);

  ReplyHeader header;
  header.points = static_cast<std::uint64_t>(out.numberofpoints);
  header.tets = static_cast<std::uint64_t>(out.numberoftetrahedra);
  header.faces = static_cast<std::uint64_t>(out.numberoftrifaces);
  std::vector<std::array<int, 4>> faces(header.faces);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::copy_n(out.trifacelist + 3 * f, 3, faces[f].data());
    // Those of the convex hull that are on no triangle have the marker 0, or a negative one.
    faces[f][3] = std::max(out.trifacemarkerlist[f], 0) - 1;
  }
  ReplyWriter reply;
  reply.add(out.pointlist, header.points * 3 * sizeof(REAL));
  reply.add(out.tetrahedronlist, header.tets * 4 * sizeof(int));
  reply.add(faces.data(), faces.size() * sizeof(faces[0]));
  reply.finish(header);
}

void find_intersections(Request& request) {
  ::tetgenio in, out;
  fill(in, request);
  ::tetrahedralize(request.header.switches, &in, &out);

  // TetGen leaves the triangles that intersect any other, not which. Its test is asked again for the first
  // ones.
  const std::span<const int> markers(out.trifacemarkerlist, static_cast<std::size_t>(out.numberoftrifaces));
  const auto corner = [&](int marker, std::size_t k) {
    return request.points[request.triangles[static_cast<std::size_t>(marker) - 1][k]].data();
  };
  ::tetgenmesh test;
  std::vector<std::array<Index, 2>> pairs;
  constexpr std::size_t enough = 8, most_tests = 1000;
  for (std::size_t i = 0; i < std::min(markers.size(), most_tests) && pairs.size() < enough; ++i)
    for (std::size_t j = i + 1; j < markers.size(); ++j) {
      const int a = markers[i], b = markers[j];
      const int how = test.tri_tri_inter(corner(a, 0), corner(a, 1), corner(a, 2), corner(b, 0), corner(b, 1),
                                         corner(b, 2));
      if (how != static_cast<int>(::tetgenmesh::INTERSECT) &&
          how != static_cast<int>(::tetgenmesh::SHAREFACE))
        continue;
      pairs.push_back({static_cast<Index>(std::min(a, b)) - 1, static_cast<Index>(std::max(a, b)) - 1});
      break;
    }
  ReplyHeader header;
  header.pairs = pairs.size();
  ReplyWriter reply;
  reply.add(pairs.data(), pairs.size() * sizeof(pairs[0]));
  reply.finish(header);
}

}  // namespace multimesh::tetgen::worker
