// SPDX-License-Identifier: BSD-3-Clause
// Copies of vertices as tables for solvers.
#include <algorithm>

#include "adapters/io/output_buffer.hpp"
#include "adapters/io/second_order.hpp"
#include "multimesh/files/tile_file.hpp"

namespace multimesh::files {

namespace {

constexpr std::string_view upper = "XYZ";

Vec3 period(const PeriodicDomain& domain, std::size_t axis) {
  LatticeVector unit{};
  unit[axis] = 1;
  return domain.lattice().shift(unit);
}

void put_vector(io::OutputBuffer& out, const Vec3& v, std::string_view separator) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0) out.text(separator);
    out.number(v[i]);
  }
}

/// One equation; at most four terms per line.
class Equation {
 public:
  Equation(io::OutputBuffer& out, std::size_t terms) : out_(out), left_(terms) {
    out_.text("*EQUATION\n");
    out_.number(terms);
    out_.character('\n');
  }
  void add(std::size_t node, int degree, int factor) {
    out_.number(node);
    out_.text(", ");
    out_.number(degree);
    out_.text(", ");
    out_.number(factor);
    out_.text(".");
    out_.text(--left_ == 0 || ++in_line_ == 4 ? "\n" : ", ");
    if (in_line_ == 4) in_line_ = 0;
  }

 private:
  io::OutputBuffer& out_;
  std::size_t left_;
  int in_line_ = 0;
};

void put_reference_nodes(io::OutputBuffer& out, const PeriodicDomain& domain, std::size_t last) {
  out.text(
      "** Periodic boundary conditions: u(slave) - u(master) = sum of the displacements of the\n"
      "** reference nodes of the periods between them. Include after the nodes of the tile.\n");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!domain.lattice().is_periodic(static_cast<int>(axis))) continue;
    out.text("** period ");
    out.character(upper[axis]);
    out.text(": ");
    put_vector(out, period(domain, axis), ", ");
    out.text("\n*NODE, NSET=REF_");
    out.character(upper[axis]);
    out.character('\n');
    out.number(last + 1 + axis);
    out.text(", ");
    put_vector(out, period(domain, axis), ", ");
    out.character('\n');
  }
}

/// The nodes of a written tile, and which of them are copies.
struct Nodes {
  std::size_t count = 0;
  std::vector<PeriodicCopy> copies;
};

/// The nodes in the middles of edges that are copies. Edges are copies of one another if their ends are: the
/// glued tile has at most one edge between two vertices.
std::vector<PeriodicCopy> copies_of_middles(const std::vector<std::array<Index, 2>>& edges,
                                            const Nodes& nodes) {
  std::vector<PeriodicCopy> of_vertex(nodes.count, {no_index, no_index, {}});
  for (const PeriodicCopy& c : nodes.copies) of_vertex[c.slave] = c, of_vertex[c.master].master = c.master;
  struct Middle {
    std::array<Index, 2> ends;  // their masters
    Index number;
    LatticeVector shift;  // of the first end
  };
  std::vector<Middle> middles;
  auto number = static_cast<Index>(nodes.count);
  for (const auto& [a, b] : edges) {
    const PeriodicCopy *one = &of_vertex[a], *other = &of_vertex[b];
    if (other->master < one->master) std::swap(one, other);
    if (other->master != no_index) middles.push_back({{one->master, other->master}, number, one->shift});
    ++number;
  }
  std::ranges::stable_sort(middles, {}, &Middle::ends);
  std::vector<PeriodicCopy> copies;
  for (std::size_t i = 1, first = 0; i < middles.size(); ++i)
    if (middles[i].ends != middles[first].ends)
      first = i;
    else
      copies.push_back({middles[i].number, middles[first].number, middles[i].shift - middles[first].shift});
  return copies;
}

Nodes nodes_of(const PeriodicDomain& domain, int order) {
  const PeriodicTile tile = domain.tile_lists();
  Nodes nodes{tile.points.size(), domain.copies()};
  if (order == 1) return nodes;
  io::SimplexSoup soup;
  soup.simplices[static_cast<std::size_t>(tile.facets.dimension)] = {
      tile.facets.corners, std::vector<std::int32_t>(tile.facets.size()), {}};
  const auto edges = io::edges_with_middles(soup);
  const auto middles = copies_of_middles(edges, nodes);
  nodes.copies.insert(nodes.copies.end(), middles.begin(), middles.end());
  nodes.count += edges.size();
  return nodes;
}

}  // namespace

void write_pair_table(const std::filesystem::path& path, const PeriodicDomain& domain, int order) {
  io::AtomicFile file(path);
  io::OutputBuffer out(file);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!domain.lattice().is_periodic(static_cast<int>(axis))) continue;
    out.text("# period ");
    out.character("xyz"[axis]);
    out.text(": ");
    put_vector(out, period(domain, axis), " ");
    out.character('\n');
  }
  out.text("slave,master,kx,ky,kz\n");
  for (const auto& [slave, master, shift] : nodes_of(domain, order).copies) {
    out.number(std::size_t{slave} + 1);
    out.character(',');
    out.number(std::size_t{master} + 1);
    for (const int k : shift) {
      out.character(',');
      out.number(k);
    }
    out.character('\n');
  }
  out.flush();
  file.commit();
}

void write_abaqus_equations(const std::filesystem::path& path, const PeriodicDomain& domain, int order) {
  io::AtomicFile file(path);
  io::OutputBuffer out(file);
  const Nodes nodes = nodes_of(domain, order);
  const std::size_t last = nodes.count;
  put_reference_nodes(out, domain, last);
  const int degrees = domain.tree().mesh(domain.tile()).dimension();
  for (const auto& [slave, master, shift] : nodes.copies)
    for (int degree = 1; degree <= degrees; ++degree) {
      Equation equation(
          out, 2 + static_cast<std::size_t>(std::ranges::count_if(shift, [](int k) { return k != 0; })));
      equation.add(std::size_t{slave} + 1, degree, 1);
      equation.add(std::size_t{master} + 1, degree, -1);
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (shift[axis] != 0) equation.add(last + 1 + axis, degree, -shift[axis]);
    }
  out.flush();
  file.commit();
}

}  // namespace multimesh::files
