// SPDX-License-Identifier: BSD-3-Clause
// Properties of the user's, of whatever type, that a mesh carries through collapses and flips. OpenMesh's
// property base class can copy and exchange values within a mesh: what is written over is exchanged with a
// dead element's, and comes back when that is done again.
#include <algorithm>
#include <cstring>
#include <string>
#include <typeinfo>

#include "adapters/openmesh/kept_values.hpp"
#include "multimesh/error.hpp"
#include "multimesh/openmesh/connectivity.hpp"

namespace multimesh::openmesh {

namespace {

/// Those that are united where two edges become one.
constexpr unsigned flags = OpenMesh::Attributes::LOCKED | OpenMesh::Attributes::SELECTED |
                           OpenMesh::Attributes::FEATURE | OpenMesh::Attributes::TAGGED |
                           OpenMesh::Attributes::TAGGED2;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

void Connectivity::leave(const OpenMesh::BaseProperty& property, std::function<bool()> still) {
  std::erase_if(left_, [&](const Left& l) { return l.property == &property; });
  left_.push_back({&property, std::move(still)});
}

bool Connectivity::is_left(const OpenMesh::BaseProperty& property) const {
  return std::any_of(left_.begin(), left_.end(),
                     [&](const Left& l) { return l.property == &property && l.still(); });
}

// Every mesh with traits has such a property, which has no name, of a class without members if the traits say
// nothing.
void Connectivity::find_data_of_default_traits() {
  const auto find = [](auto begin, auto end) -> const OpenMesh::BaseProperty* {
    for (auto p = begin; p != end; ++p)
      if (*p && std::strstr(typeid(**p).name(), "PropertyTINS_13DefaultTraits")) return *p;
    return nullptr;
  };
  no_data_[0] = find(om_.eprops_begin(), om_.eprops_end());
  no_data_[1] = find(om_.hprops_begin(), om_.hprops_end());
}

// By names, as OpenMesh and we give them: its own access to the status compares the names of types first,
// each time. Comparisons of a fixed size need no call.
inline bool Connectivity::is_carried(const OpenMesh::BaseProperty& property) const {
  if (&property == no_data_[0] || &property == no_data_[1]) return false;
  const std::string& name = property.name();
  if (name.size() > 3 && std::memcmp(name.data(), "mm:", 3) == 0) return false;
  if (name.size() == 8 &&
      (std::memcmp(name.data(), "e:status", 8) == 0 || std::memcmp(name.data(), "h:status", 8) == 0))
    return false;
  return left_.empty() || !is_left(property);
}

template <class Visit>
void Connectivity::for_each_edge_property(const Visit& visit) const {
  for (auto p = om_.eprops_begin(); p != om_.eprops_end(); ++p)
    if (*p && is_carried(**p)) visit(**p);
}

template <class Visit>
void Connectivity::for_each_halfedge_property(const Visit& visit) const {
  for (auto p = om_.hprops_begin(); p != om_.hprops_end(); ++p)
    if (*p && is_carried(**p)) visit(**p);
}

Connectivity::Carried Connectivity::what_is_carried() const {
  Carried any{false, false};
  for_each_edge_property([&](const auto&) { any.by_edges = true; });
  for_each_halfedge_property([&](const auto&) { any.by_halfedges = true; });
  return any;
}

bool Connectivity::has_values(int k) const {
  return k == 1 && dimension() == 2 && what_is_carried().by_edges;
}

void Connectivity::keep(int k, std::unique_ptr<ValueList> values) {
  const auto add = [&](auto handle) {
    om_.add_property(handle, values->name());
    om_.property(handle).set(std::move(values), capacity(k));
  };
  if (k == 0) return add(OpenMesh::VPropHandleT<Kept>());
  if (k == 1) return add(OpenMesh::EPropHandleT<Kept>());
  if (k != 2 || dimension() < 2)
    throw UsageError("the mesh has no simplices of dimension " + std::to_string(k));
  add(OpenMesh::FPropHandleT<Kept>());
}

namespace {

/// Removes the property of this kind that keeps the values; false if none does. Its handle is its place.
template <class Handle, class Iterator>
bool remove_kept(OpenMesh::PolyConnectivity& om, Iterator begin, Iterator end, const void* values) {
  for (Iterator p = begin; p != end; ++p) {
    const auto* kept = dynamic_cast<const OpenMesh::PropertyT<Kept>*>(*p);
    if (!kept || !kept->are_in(values)) continue;
    Handle handle(static_cast<int>(p - begin));
    om.remove_property(handle);
    return true;
  }
  return false;
}

}  // namespace

void Connectivity::drop(int k, const void* values) {
  if (!log_.empty()) throw UsageError("values cannot be removed inside a transaction");
  const bool removed =
      k == 0   ? remove_kept<OpenMesh::VPropHandleT<Kept>>(om_, om_.vprops_begin(), om_.vprops_end(), values)
      : k == 1 ? remove_kept<OpenMesh::EPropHandleT<Kept>>(om_, om_.eprops_begin(), om_.eprops_end(), values)
               : remove_kept<OpenMesh::FPropHandleT<Kept>>(om_, om_.fprops_begin(), om_.fprops_end(), values);
  if (!removed) throw UsageError("these values do not belong to the mesh");
}

void Connectivity::exchange_edge_values(int kept, int dying) {
  log(Word::edge_values, static_cast<std::uint32_t>(kept), static_cast<std::uint32_t>(dying));
  exchange(log_.back());
}

void Connectivity::exchange_halfedge_values(int kept, int dying) {
  log(Word::halfedge_values, static_cast<std::uint32_t>(kept), static_cast<std::uint32_t>(dying));
  exchange(log_.back());
}

void Connectivity::exchange(const Entry& e) {
  const std::size_t i = e.index, j = e.old;
  const auto of_edges = [&](OpenMesh::BaseProperty& p) { p.swap(i, j); };
  const auto of_both_halfedges = [&](OpenMesh::BaseProperty& p) {
    p.swap(2 * i, 2 * j);
    p.swap(2 * i + 1, 2 * j + 1);
  };
  if (e.word == Word::halfedge_values) return for_each_halfedge_property(of_edges);
  for_each_edge_property(of_edges);
  if (e.word == Word::renewed) for_each_halfedge_property(of_both_halfedges);
}

void Connectivity::renew_edge(int halfedge, int like, int opposite_like) {
  const int e = halfedge >> 1;
  if (const unsigned bits = (*edge_status_)[at(e)].bits(); bits != 0) {
    log(Word::edge_status, static_cast<std::uint32_t>(e), bits);
    write_edge_status(static_cast<std::uint32_t>(e), 0);
  }
  const Carried any = what_is_carried();
  if (!any.by_edges && !any.by_halfedges) return;
  log(Word::renewed, static_cast<std::uint32_t>(e), static_cast<std::uint32_t>(make_spare(1)));
  exchange(log_.back());
  for_each_halfedge_property([&](OpenMesh::BaseProperty& p) {
    p.copy(at(like), at(halfedge));
    p.copy(at(opposite_like), at(halfedge ^ 1));
  });
}

void Connectivity::unite_edge_flags(int kept, int other) {
  const unsigned more = (*edge_status_)[at(other)].bits() & flags;
  if (more == 0) return;
  const unsigned bits = (*edge_status_)[at(kept)].bits();
  if ((more & ~bits) == 0) return;
  log(Word::edge_status, static_cast<std::uint32_t>(kept), bits);
  write_edge_status(static_cast<std::uint32_t>(kept), bits | more);
}

}  // namespace multimesh::openmesh
