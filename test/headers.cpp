// SPDX-License-Identifier: BSD-3-Clause
// The target with the precompiled header of all tests needs a source.
