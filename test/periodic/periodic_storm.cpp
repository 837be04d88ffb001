// SPDX-License-Identifier: BSD-3-Clause
#include "test/periodic/periodic_storm.hpp"

#include <algorithm>
#include <cmath>

#include "multimesh/tet/tet_mesh.hpp"
#include "multimesh/validate.hpp"
#include "test/oracle/big_integer.hpp"

namespace multimesh::test {

namespace {

std::size_t live_facets(const Mesh& mesh) {
  std::size_t n = 0;
  for (Index f = 0; f < mesh.capacity(mesh.dimension()); ++f) n += mesh.is_live(mesh.dimension(), f);
  return n;
}

/// Exactly, by arithmetic of another kind.
bool is_positive(const PeriodicDomain& domain, Index facet, const Vec3& normal) {
  const Mesh& mesh = domain.tree().mesh(domain.tile());
  std::array<Index, 4> corners{};
  const bool is_flat = mesh.dimension() == 2;
  if (is_flat) {
    mesh.vertices(mesh.dart_of(2, facet), corners.data());
  } else {
    std::copy_n(dynamic_cast<const tet::TetMesh&>(mesh).corners(facet), 4, corners.begin());
  }
  std::array<std::array<double, 3>, 4> p{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 at = is_flat && i == 3 ? normal : domain.positions()[corners[i]];
    p[i] = {at[0], at[1], at[2]};
  }
  return oracle::exact_orientation(p, is_flat) > 0;
}

}  // namespace

PeriodicStorm::PeriodicStorm(PeriodicDomain& domain, unsigned seed, bool shape)
    : domain_(domain),
      operations_(domain.tree()),
      positive_(domain.positions(), mean_normal(domain)),
      shape_(shape),
      random_(seed) {
  domain.attach(operations_);
  if (shape) operations_.add(positive_);
  const Mesh& root = domain.tree().mesh(NodeId::root);
  live_ = facets_at_start_ = live_facets(root);
  step_size_ = 0.1 * domain.diagonal() / std::pow(double(live_), 1.0 / root.dimension());
}

Dart PeriodicStorm::random_dart(NodeId n) {
  const Mesh& mesh = domain_.tree().mesh(n);
  const int d = mesh.dimension();
  for (;;) {
    const auto f = static_cast<Index>(random_() % mesh.capacity(d));
    if (!mesh.is_live(d, f)) continue;
    return mesh.reorder(mesh.dart_of(d, f), {static_cast<std::uint8_t>(random_() % (d == 3   ? 24
                                                                                    : d == 2 ? 6
                                                                                             : 2))});
  }
}

bool PeriodicStorm::move(NodeId n, Dart d) {
  const auto coordinate = [&] { return step_size_ * (double(random_() % 2001) / 1000 - 1); };
  Vec3 by(coordinate(), coordinate(), coordinate());
  const Mesh& root = domain_.tree().mesh(NodeId::root);
  if (root.dimension() == 2) {  // in its plane
    const Vec3 normal = mean_normal(domain_);
    by -= normal * dot(normal, by);
  }
  if (!domain_.move(operations_, n, d, by)) return false;
  ++moved_with_copies[std::min<std::size_t>(8, operations_.copies().count(domain_.tile()))];
  return true;
}

void PeriodicStorm::step() {
  const MultiMesh& tree = domain_.tree();
  if (steps_++ % 64 == 0) {
    const Mesh& root = tree.mesh(NodeId::root);
    live_ = live_facets(root);
    if (root.capacity(root.dimension()) > 4 * live_ + 1000) domain_.tree().compact();
  }
  const auto nodes = tree.nodes();
  NodeId n = nodes[random_() % nodes.size()];
  if (tree.mesh(n).dimension() == 0) n = NodeId::root;  // points have no edges
  const Dart d = random_dart(n);
  auto choice = static_cast<unsigned>(random_() % 100);
  if (live_ > 2 * facets_at_start_) choice = 35 + choice / 2;
  if (live_ < facets_at_start_ / 2) choice /= 3;
  bool ok = false;
  if (choice < 35) {
    ok = bool(operations_.split(n, d, 0.25 * static_cast<double>(1 + random_() % 3)));
  } else if (choice < 70) {
    ok = bool(operations_.collapse(n, d, Placement::at(0.125 * static_cast<double>(random_() % 9))));
  } else if (choice < 80) {
    ok = bool(operations_.swap(n, d));
  } else if (choice < 85) {
    ok = bool(tree.mesh(n).dimension() == 3 ? operations_.swap_face(n, d) : operations_.swap(n, d));
  } else {
    ok = move(n, d);
  }
  ok ? ++done : ++refused;
}

std::string PeriodicStorm::fault() const {
  const MultiMesh& tree = domain_.tree();
  if (const auto problems = validate(tree); !problems.empty()) return problems.front();
  if (const double m = domain_.mismatch(); !(m <= 1e-9)) return "copies differ by " + std::to_string(m);
  if (!shape_) return {};
  const Mesh& mesh = tree.mesh(domain_.tile());
  const Vec3 normal = mean_normal(domain_);
  for (Index f = 0; f < mesh.capacity(mesh.dimension()); ++f)
    if (mesh.is_live(mesh.dimension(), f) && !is_positive(domain_, f, normal))
      return "facet " + std::to_string(f) + " of the tile is inverted";
  return {};
}

}  // namespace multimesh::test
