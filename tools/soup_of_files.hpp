// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "multimesh/algorithms/insert.hpp"
#include "multimesh/files/domain_file.hpp"

namespace multimesh::tools {

/// The triangles of several files, with one label for each group of each file.
struct SoupOfFiles {
  TriangleSoup soup;
  std::vector<io::SimplexSoup::Group> patches;  ///< the names of the labels: of groups, else of files
  std::vector<std::string> warnings;
};

/// \throw InputError as files::read_domain(), and naming the file if it has no triangles
SoupOfFiles read_soup(const std::vector<std::string>& paths);

}  // namespace multimesh::tools
