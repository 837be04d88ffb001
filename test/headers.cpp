// SPDX-License-Identifier: BSD-3-Clause
// Of the target that has the precompiled header of all tests; it needs a source.
