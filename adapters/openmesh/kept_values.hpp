// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <memory>

#include "multimesh/value_list.hpp"

namespace multimesh::openmesh {

/// The type of an OpenMesh property whose values have a type that only the list knows.
struct Kept {};

}  // namespace multimesh::openmesh

/// Makes a ValueList follow an OpenMesh mesh like its other properties, copies of the mesh included.
template <>
class OpenMesh::PropertyT<multimesh::openmesh::Kept> final : public OpenMesh::BaseProperty {
 public:
  using Value = multimesh::openmesh::Kept;
  using List = multimesh::ValueList;
  using BaseProperty::BaseProperty;
  PropertyT(const PropertyT& p) : BaseProperty(p), list_(p.list_ ? p.list_->clone() : nullptr) {}

  void set(std::unique_ptr<List> list, std::size_t n) {
    list_ = std::move(list);
    list_->resize(n);
  }

  bool are_in(const void* list) const { return list_ && list_->are_in(list); }

  void reserve(std::size_t) override {}
  void resize(std::size_t n) override {
    if (list_) list_->resize(n);
  }
  void clear() override { resize(0); }
  void push_back() override { resize(n_elements() + 1); }
  void swap(std::size_t i, std::size_t j) override { list_->swap(index(i), index(j)); }
  void copy(std::size_t i, std::size_t j) override { list_->copy(index(i), index(j)); }
  PropertyT* clone() const override { return new PropertyT(*this); }

  void set_persistent(bool) override {}
  std::string get_storage_name() const override { return "multimesh values"; }
  std::size_t n_elements() const override { return list_ ? list_->size() : 0; }
  std::size_t element_size() const override { return UnknownSize; }
  std::size_t size_of() const override { return UnknownSize; }
  std::size_t size_of(std::size_t) const override { return UnknownSize; }
  std::size_t store(std::ostream&, bool) const override { return 0; }
  std::size_t restore(std::istream&, bool) override { return 0; }

 private:
  static multimesh::Index index(std::size_t i) { return static_cast<multimesh::Index>(i); }
  std::unique_ptr<List> list_;
};
