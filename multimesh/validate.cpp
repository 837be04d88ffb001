// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/validate.hpp"

#include <array>

namespace multimesh {

namespace {

class Validator {
 public:
  explicit Validator(const MultiMesh& tree) : tree_(tree) {}

  std::vector<std::string> run() {
    for (const NodeId n : tree_.nodes()) {
      where_ = "mesh " + std::to_string(index(n)) + ": ";
      std::vector<std::string> found;
      tree_.mesh(n).check(found);
      if (found.empty())
        for (int k = 1; k <= tree_.mesh(n).dimension(); ++k) check_simplices_differ(tree_.mesh(n), k, found);
      for (const std::string& f : found) report(f);
    }
    if (!problems_.empty()) return std::move(problems_);  // darts could not be followed
    for (const NodeId n : tree_.nodes()) {
      if (n == NodeId::root) continue;
      where_ = "map of mesh " + std::to_string(index(n)) + ": ";
      if (anchors_live(n)) {
        map_is_simplicial(n);
        links_match(n);
      }
    }
    return std::move(problems_);
  }

 private:
  void report(const std::string& fault) { problems_.push_back(where_ + fault); }

  bool anchors_live(NodeId n) {
    const Mesh& below = tree_.mesh(n);
    const Mesh& above = tree_.mesh(tree_.parent(n));
    const int k = below.dimension();
    const std::size_t before = problems_.size();
    for (Index f = 0; f < below.capacity(k); ++f) {
      if (!below.is_live(k, f)) continue;
      const Anchor a = below.anchor(f);
      if (!below.is_dart(a.own) || below.facet(a.own) != f)
        report("the anchor of facet " + std::to_string(f) + " is not at one of its darts");
      if (!above.is_dart(a.parent))
        report("the anchor of facet " + std::to_string(f) + " is at a dead dart of the parent");
    }
    return problems_.size() == before;
  }

  void map_is_simplicial(NodeId n) {
    const Mesh& below = tree_.mesh(n);
    const Mesh& above = tree_.mesh(tree_.parent(n));
    const int k = below.dimension();
    std::vector<Index> image(below.capacity(0), no_index);
    std::array<Index, 4> from{}, to{};
    for (Index f = 0; f < below.capacity(k); ++f) {
      if (!below.is_live(k, f)) continue;
      const Anchor a = below.anchor(f);
      below.vertices(a.own, from.data());
      above.vertices(a.parent, to.data());
      for (std::size_t i = 0; i <= static_cast<std::size_t>(k); ++i) {
        Index& known = image[from[i]];
        if (known != no_index && known != to[i])
          report("vertex " + std::to_string(from[i]) + " has the images " + std::to_string(known) + " and " +
                 std::to_string(to[i]));
        known = to[i];
      }
    }
  }

  void links_match(NodeId n) {
    const Mesh& below = tree_.mesh(n);
    const Mesh& above = tree_.mesh(tree_.parent(n));
    const int k = below.dimension();
    for (Index f = 0; f < below.capacity(k); ++f)
      if (below.is_live(k, f) && tree_.facet_over(n, below.anchor(f).parent) != f)
        report("facet " + std::to_string(f) + " is not linked from its image");
    for (Index s = 0; s < above.capacity(k); ++s) {
      if (!above.is_live(k, s)) continue;
      const Dart d = above.dart_of(k, s);
      if (d == no_dart) continue;  // a vertex without facets
      const Index f = tree_.facet_over(n, d);
      if (f == no_index) continue;
      if (!below.is_live(k, f)) {
        report("parent simplex " + std::to_string(s) + " is linked to dead facet " + std::to_string(f));
      } else if (above.simplex(below.anchor(f).parent, k) != s) {
        report("parent simplex " + std::to_string(s) + " is linked to facet " + std::to_string(f) +
               ", which lies elsewhere");
      }
    }
  }

  const MultiMesh& tree_;
  std::string where_;
  std::vector<std::string> problems_;
};

}  // namespace

std::vector<std::string> validate(const MultiMesh& tree) {
  return Validator(tree).run();
}

}  // namespace multimesh
