// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "multimesh/event.hpp"

namespace multimesh {

/// A predicate on an operation. If it fails before, nothing has been touched; if it fails after, everything
/// is rolled back. Prefer to decide before, on the predicted star, where possible: it is cheaper.
class Invariant {
 public:
  /// `node`: the mesh that refusals name.
  explicit Invariant(std::string name, NodeId node = NodeId::root) : name_(std::move(name)), node_(node) {}
  virtual ~Invariant() = default;
  Invariant(const Invariant&) = delete;
  Invariant& operator=(const Invariant&) = delete;

  const std::string& name() const noexcept { return name_; }
  NodeId node() const noexcept { return node_; }
  virtual bool before(const Event&) { return true; }
  virtual bool after(const Event&) { return true; }

 private:
  std::string name_;
  NodeId node_;
};

/// An invariant made of functions, for short algorithms and tests.
class FunctionInvariant final : public Invariant {
 public:
  using Test = std::function<bool(const Event&)>;
  FunctionInvariant(std::string name, Test before, Test after = {})
      : Invariant(std::move(name)), before_(std::move(before)), after_(std::move(after)) {}
  bool before(const Event& e) override { return !before_ || before_(e); }
  bool after(const Event& e) override { return !after_ || after_(e); }

 private:
  Test before_, after_;
};

}  // namespace multimesh
