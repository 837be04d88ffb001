// SPDX-License-Identifier: BSD-3-Clause
#include "test/property/value_columns.hpp"

#include <algorithm>

namespace multimesh::test {

namespace {

constexpr unsigned status_bits = OpenMesh::Attributes::FEATURE | OpenMesh::Attributes::SELECTED |
                                 OpenMesh::Attributes::TAGGED | OpenMesh::Attributes::LOCKED;

int number(std::mt19937& random) {
  return static_cast<int>(random() % 1000) + 1;
}

ColumnRules<double> shared_out() {
  return {.halve = [](const double& whole, double share) { return whole * share; },
          .swap = [](const double& own, const double& other) { return own + 2 * other; }};
}

}  // namespace

Values ValueColumns::OfKind::at(std::size_t i) const {
  Values v;
  if (!plain.empty()) v.plain = plain.at(i);
  if (carried) v.carried = carried->at(i);
  if (larger) v.larger = larger->at(i);
  if (flags) v.flags = flags->at(i);
  if (mean) v.mean = mean->at(i);
  if (part) v.part = part->at(i);
  return v;
}

void ValueColumns::OfKind::fill(std::mt19937& random) {
  const auto all = [&](auto* values) {
    if (!values) return;
    for (auto& v : *values)
      v = static_cast<typename std::decay_t<decltype(*values)>::value_type>(number(random));
  };
  all(&plain), all(carried), all(larger), all(flags), all(mean), all(part);
}

ValueColumns::ValueColumns(Propagation& operations, MultiMesh& tree, NodeId n, std::mt19937& random)
    : operations_(operations), mesh_(tree.mesh(n)), node_(n) {
  openmesh_ = dynamic_cast<openmesh::Connectivity*>(&mesh_);
  tets_ = dynamic_cast<tet::TetMesh*>(&mesh_);
  facets_.k = mesh_.dimension();
  openmesh_ ? add_to_openmesh(random) : add_to_tetrahedra(random);
}

template <class T, template <class> class Handle>
std::vector<T>& ValueColumns::property(const char* name, bool left) {
  Handle<T> handle;
  openmesh_->openmesh().add_property(handle, name);
  if (left) openmesh_->leave(openmesh_->openmesh().property(handle), [] { return true; });
  return openmesh_->openmesh().property(handle).data_vector();
}

template <class A, class... Arguments>
void ValueColumns::follow_by(Arguments&&... arguments) {
  attributes_.push_back(std::make_unique<A>(node_, std::forward<Arguments>(arguments)...));
  operations_.add(*attributes_.back());
}

void ValueColumns::add_to_openmesh(std::mt19937& random) {
  using namespace OpenMesh;
  const bool surface = mesh_.dimension() == 2;
  if (mesh_.dimension() == 0) return add_to_points(random);
  vertices_.carried = &property<int, VPropHandleT>("carried", false);
  vertices_.mean = &property<double, VPropHandleT>("mean", false);
  corners_.carried = &property<int, HPropHandleT>("carried", false);
  corners_.mean = &property<double, HPropHandleT>("mean", true);
  if (surface) {
    edges_.carried = &property<int, EPropHandleT>("carried", false);
    edges_.flags = &property<unsigned, EPropHandleT>("flags", true);
    edges_.larger = &property<int, EPropHandleT>("larger", true);
    edges_.mean = &property<double, EPropHandleT>("mean", true);
    edges_.plain.resize(mesh_.capacity(1));
  }
  facets_.carried = surface ? &property<int, FPropHandleT>("carried", false)
                            : &property<int, EPropHandleT>("carried", false);
  facets_.part =
      surface ? &property<double, FPropHandleT>("part", true) : &property<double, EPropHandleT>("part", true);
  vertices_.plain.resize(mesh_.capacity(0));
  facets_.plain.resize(mesh_.capacity(mesh_.dimension()));
  corners_.plain.resize(mesh_.corner_capacity());
  for (OfKind* kind : {&vertices_, &edges_, &facets_, &corners_}) kind->fill(random);

  follow_by<VertexAttribute<int>>(vertices_.plain);
  follow_by<VertexAttribute<double>>(*vertices_.mean);
  if (surface) {
    follow_by<Column<int>>(1, edges_.plain, ColumnRules<int>{.fresh = fresh_plain});
    follow_by<Column<unsigned>>(1, *edges_.flags, ColumnRules<unsigned>::unite());
    follow_by<Column<int>>(1, *edges_.larger, ColumnRules<int>::larger());
    follow_by<Column<double>>(1, *edges_.mean, ColumnRules<double>::interpolate());
    for (const auto e : openmesh_->openmesh().all_edges())
      if (!openmesh_->openmesh().status(e).deleted())
        openmesh_->openmesh().status(e).set_bits(static_cast<unsigned>(random()) & status_bits);
  }
  follow_by<Column<int>>(facets_.k, facets_.plain);
  follow_by<Column<double>>(facets_.k, *facets_.part, shared_out());
  follow_by<Column<int>>(corners, corners_.plain);
  follow_by<Column<double>>(corners, *corners_.mean, ColumnRules<double>::interpolate());
}

// Values on points are those on vertices.
void ValueColumns::add_to_points(std::mt19937& random) {
  vertices_.carried = &property<int, OpenMesh::VPropHandleT>("carried", false);
  vertices_.mean = &property<double, OpenMesh::VPropHandleT>("mean", false);
  vertices_.plain.resize(mesh_.capacity(0));
  vertices_.fill(random);
  follow_by<VertexAttribute<int>>(vertices_.plain);
  follow_by<VertexAttribute<double>>(*vertices_.mean);
}

void ValueColumns::add_to_tetrahedra(std::mt19937& random) {
  vertices_.carried = &tets_->add_vertex_property<int>("carried").values;
  facets_.carried = &tets_->add_tet_property<int>("carried").values;
  vertices_.plain.resize(mesh_.capacity(0));
  facets_.plain.resize(mesh_.capacity(3));
  vertices_.mean = doubles_.emplace_back(std::make_unique<std::vector<double>>(mesh_.capacity(0))).get();
  facets_.part = doubles_.emplace_back(std::make_unique<std::vector<double>>(mesh_.capacity(3))).get();
  for (OfKind* kind : {&vertices_, &facets_}) kind->fill(random);
  follow_by<VertexAttribute<int>>(vertices_.plain);
  follow_by<VertexAttribute<double>>(*vertices_.mean);
  follow_by<Column<int>>(3, facets_.plain);
  follow_by<Column<double>>(3, *facets_.part, shared_out());
  const auto merge = [](const Values& kept, const Values& other, double share) {
    Values v = kept;
    v.flags |= other.flags;
    v.larger = std::max(kept.larger, other.larger);
    v.mean = (1 - share) * kept.mean + share * other.mean;
    return v;
  };
  for (const int k : {1, 2}) {
    carried_sparse_[k] = &tets_->add_simplex_property<int>(k, "carried" + std::to_string(k));
    ruled_sparse_[k] = &tets_->add_simplex_property<Values>(k, "ruled" + std::to_string(k), merge);
    for (Index s = 0; s < tets_->capacity(k); ++s) {
      if (!tets_->is_live(k, s) || random() % 2 == 0) continue;
      Values v;
      v.flags = static_cast<unsigned>(random() % 16), v.larger = number(random), v.mean = number(random);
      tets_->set_value(*carried_sparse_[k], tets_->dart_of(k, s), number(random));
      tets_->set_value(*ruled_sparse_[k], tets_->dart_of(k, s), v);
    }
  }
  tets_->forget();
}

namespace {

void move_all(std::vector<int>& values, const std::vector<Index>& place, std::size_t n) {
  std::vector<int> moved(n);
  for (std::size_t i = 0; i < place.size(); ++i)
    if (place[i] != no_index) moved.at(place[i]) = values.at(i);
  values = std::move(moved);
}

void move_all(std::vector<double>& values, const std::vector<Index>& place, std::size_t n) {
  std::vector<double> moved(n);
  for (std::size_t i = 0; i < place.size(); ++i)
    if (place[i] != no_index) moved.at(place[i]) = values.at(i);
  values = std::move(moved);
}

}  // namespace

void ValueColumns::follow(const Compaction& moved) {
  move_all(vertices_.plain, moved.simplices[0], mesh_.capacity(0));
  const auto d = static_cast<std::size_t>(mesh_.dimension());
  if (d == 0) return;
  move_all(facets_.plain, moved.simplices[d], mesh_.capacity(mesh_.dimension()));
  if (tets_) {
    move_all(*vertices_.mean, moved.simplices[0], mesh_.capacity(0));
    move_all(*facets_.part, moved.simplices[3], mesh_.capacity(3));
    return;
  }
  if (d == 2) move_all(edges_.plain, moved.simplices[1], mesh_.capacity(1));
  std::vector<Index> halfedges;
  for (const Index e : moved.simplices[1])
    for (const Index side : {0U, 1U}) halfedges.push_back(e == no_index ? no_index : 2 * e + side);
  move_all(corners_.plain, halfedges, mesh_.corner_capacity());
}

ValueMesh ValueColumns::read() const {
  ValueMesh out;
  out.dimension = mesh_.dimension();
  for (Index v = 0; v < mesh_.capacity(0); ++v)
    if (mesh_.is_live(0, v)) out.vertices[v] = vertices_.at(v);
  openmesh_ ? read_openmesh(out) : read_tetrahedra(out);
  return out;
}

void ValueColumns::read_openmesh(ValueMesh& out) const {
  const OpenMesh::PolyConnectivity& om = openmesh_->openmesh();
  const auto index = [](const auto& handle) { return static_cast<unsigned>(handle.idx()); };
  for (const auto e : om.all_edges()) {
    if (om.status(e).deleted()) continue;
    const auto h = om.halfedge_handle(e, 0);
    const unsigned from = index(om.from_vertex_handle(h)), to = index(om.to_vertex_handle(h));
    if (out.dimension == 1) {
      out.facets[{from, to}] = {
          {from, to},
          facets_.at(index(e)),
          {{to, corners_.at(index(h))}, {from, corners_.at(index(om.opposite_halfedge_handle(h)))}}};
    } else {
      Values& v = out.edges[{from, to}] = edges_.at(index(e));
      v.status = om.status(e).bits() & status_bits;
    }
  }
  for (const auto f : om.all_faces()) {
    if (om.status(f).deleted()) continue;
    Facet facet;
    facet.values = facets_.at(index(f));
    for (const auto h : om.fh_range(f)) {
      facet.order.push_back(index(om.to_vertex_handle(h)));
      facet.corners[facet.order.back()] = corners_.at(index(h));
    }
    out.facets[{facet.order.begin(), facet.order.end()}] = facet;
  }
}

Values ValueColumns::sparse(int k, Dart d) const {
  Values v = *tets_->value(*ruled_sparse_[k], d);
  v.carried = *tets_->value(*carried_sparse_[k], d);
  return v;
}

void ValueColumns::read_tetrahedra(ValueMesh& out) const {
  for (Index t = 0; t < mesh_.capacity(3); ++t) {
    if (!mesh_.is_live(3, t)) continue;
    const Index* v = tets_->corners(t);
    out.facets[{v, v + 4}] = {{v, v + 4}, facets_.at(t), {}};
  }
  for (const int k : {1, 2})
    for (Index s = 0; s < mesh_.capacity(k); ++s) {
      if (!mesh_.is_live(k, s)) continue;
      const Dart d = mesh_.dart_of(k, s);
      if (!tets_->value(*carried_sparse_[k], d)) continue;
      Index v[4];
      mesh_.vertices(d, v);
      (k == 1 ? out.edges : out.faces)[{v, v + k + 1}] = sparse(k, d);
    }
}

}  // namespace multimesh::test
