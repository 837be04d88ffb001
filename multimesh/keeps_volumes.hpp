// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "multimesh/coordinates.hpp"
#include "multimesh/invariant.hpp"

namespace multimesh {

/// Each part of a mesh of tetrahedra keeps its volume up to a share of it, while surfaces between the parts,
/// or around all of them, move. Operations that bring a volume nearer to what it was are always allowed. Its
/// journal must be among the attributes of the operations, after the coordinates'.
class KeepsVolumes final : public Invariant {
 public:
  using Part = std::function<std::int32_t(Index tet)>;
  /// \param surfaces what may move: operations on other simplices change no volume. Cost: linear
  KeepsVolumes(const MultiMesh& tree, const Coordinates& positions, Part part, std::vector<NodeId> surfaces,
               double share);

  bool before(const Event& event) override;
  bool after(const Event& event) override;
  Attribute& journal() noexcept { return journal_; }

 private:
  using Volumes = std::map<std::int32_t, double>;
  class Journal final : public Attribute {
   public:
    explicit Journal(NodeId node) : Attribute(node) {}
    void add(std::int32_t part, double volume);
    double change(std::int32_t part) const;
    void update(Operation, const VertexChange&) override {}
    Mark mark() const override { return old_.size(); }
    void rollback(Mark mark) override;
    void forget() override { old_.clear(); }

   private:
    Volumes changes_;
    std::vector<std::pair<std::int32_t, double>> old_;
  };

  bool may_change(const Event& event) const;
  void add_volumes(const Event& event, bool after);

  const Mesh& mesh_;
  const Coordinates& positions_;
  Part part_;
  std::vector<NodeId> surfaces_;
  double share_;
  Volumes all_, changed_;  // six times
  Journal journal_;
  DartBuffer star_;
  std::vector<Index> tets_;
};

}  // namespace multimesh
