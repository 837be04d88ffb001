// SPDX-License-Identifier: BSD-3-Clause
#include "tools/viewer/viewer_bundle.hpp"

namespace multimesh::tools {

const ViewerBundle* viewer_bundle() {
  return nullptr;
}

}  // namespace multimesh::tools
