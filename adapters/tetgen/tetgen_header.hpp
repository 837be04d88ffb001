// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// TetGen's header as a library. Without TETLIBRARY, which Debian's header does not define, its inline
// functions call exit(). What includes this file and is linked is under TetGen's licence, AGPL-3.
#define TETLIBRARY
#include <tetgen.h>
