// SPDX-License-Identifier: BSD-3-Clause
// Copies of vertices as tables for solvers.
#include "adapters/io/output_buffer.hpp"
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

}  // namespace

void write_pair_table(const std::filesystem::path& path, const PeriodicDomain& domain) {
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
  for (const auto& [slave, master, shift] : domain.copies()) {
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

void write_abaqus_equations(const std::filesystem::path& path, const PeriodicDomain& domain) {
  io::AtomicFile file(path);
  io::OutputBuffer out(file);
  const std::size_t last = domain.tile_lists().points.size();
  put_reference_nodes(out, domain, last);
  const int degrees = domain.tree().mesh(domain.tile()).dimension();
  for (const auto& [slave, master, shift] : domain.copies())
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
