// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// For functions of the innermost loops. These are compiled for several instruction sets in one program; an
/// out-of-line copy would be a weak symbol, and the linker could then pick the copy a machine cannot run.
#define ANVIL_INLINE inline __attribute__((always_inline))
