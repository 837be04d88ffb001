// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "oracle/overlay.hpp"

namespace multimesh::oracle {

/// The images of all simplices of a layer, each as often as it has preimages.
class LayerImage {
 public:
  explicit LayerImage(const Layer& layer) : dim_(layer.mesh->dim), images_(simplices(*layer.mesh)) {
    for (Simplex& s : images_) s = mapped(s, layer.map);
    std::sort(images_.begin(), images_.end());
  }

  int dim() const { return dim_; }

  int count(const Simplex& s) const {
    const auto [first, last] = std::equal_range(images_.begin(), images_.end(), s);
    return static_cast<int>(last - first);
  }

 private:
  int dim_;
  std::vector<Simplex> images_;
};

}  // namespace multimesh::oracle
