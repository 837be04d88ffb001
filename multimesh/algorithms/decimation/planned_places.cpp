// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimation/planned_places.hpp"

#include <algorithm>

namespace multimesh::decimation {

PlannedPlaces::PlannedPlaces(const EmbeddedMesh& surface, const CollapsePlan& plan)
    : surface_(surface), plan_(plan) {
  start();
}

void PlannedPlaces::start() {
  prescribed_.push_back(std::make_unique<PrescribedPlaces>(
      surface_.positions(), [this](const VertexChange& c) { return position(c); }));
  for (std::size_t k = 0; k < surface_.charts().size(); ++k)
    prescribed_.push_back(std::make_unique<PrescribedPlaces>(
        *surface_.charts()[k], [this, k](const VertexChange& c) { return texcoord(k, c); }));
}

// A mesh above has one vertex for all sheets. Those of a periodic tile are at different places.
std::optional<Vec3> PlannedPlaces::position(const VertexChange& c) const {
  if (c.node != surface_.node()) return plan_.position;
  std::optional<Vec3> place;
  for (std::size_t i = 0; i < plan_.n_sheets(); ++i) {
    const auto [a, b] = plan_.sheet(i);
    if (std::minmax(a, b) == std::minmax(c.a, c.b))
      place = i == 0 ? plan_.position : surface_.positions().place_of_copy(a, plan_.a, plan_.position);
  }
  return place;
}

std::optional<Vec3> PlannedPlaces::texcoord(std::size_t set, const VertexChange& c) const {
  for (const CollapsePlan::Copy& copy : plan_.copies())
    if (copy.set == set && std::minmax(copy.a, copy.b) == std::minmax(c.a, c.b))
      return in_space(copy.texcoord);
  return std::nullopt;
}

void PlannedPlaces::round(CollapsePlan& plan) const {
  plan.position = surface_.positions().rounded(plan.position);
  for (CollapsePlan::Copy& copy : plan.copies()) {
    const Vec3 x = surface_.charts()[copy.set]->rounded(in_space(copy.texcoord));
    copy.texcoord = {x[0], x[1]};
  }
}

}  // namespace multimesh::decimation
