// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace multimesh {

/// Bad input (a file, an index list, a mesh that cannot be represented). The message names the file, line or
/// element and says what to do. Nothing has been changed or written when it is thrown.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A bug of the caller: a dead dart, a dart of another mesh, a node that is not in the tree. Also checked in
/// release builds, where the check is cheap.
class UsageError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// A mesh of a tree was edited by other means than the operations of the tree, and an operation has reached
/// the edited place. Nothing has been changed when it is thrown. MultiMesh::resync() may recover.
class OutOfStepError : public UsageError {
 public:
  using UsageError::UsageError;
};

}  // namespace multimesh
