#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that objects compiled for one instruction set share no function with the rest of the program.

Usage: check_symbols.py LEVEL OBJECT...; prints each offending symbol and returns 1 when there is one.

An inline function or a template that the compiler does not inline becomes a weak symbol, and the linker keeps one copy
of each for the whole program. If that copy came from an object compiled for AVX2 or AVX-512, a machine without it would
stop with an illegal instruction, in code that has nothing to do with pair loops. So every global symbol of these objects
carries the name of its level.
"""

import re
import subprocess
import sys

# Global symbols (weak, unique or strong) with code or tables of functions.
DEFINED = re.compile(r"^\s*[0-9a-f]+ ([WVuTDBRGC]) (.+)$")
# Emitted by the compiler itself, the same bytes at every level: a pointer to the exception handler and the call of
# std::terminate.
HARMLESS = ("DW.ref.__gxx_personality_v0", "__clang_call_terminate")


def offenders(level, path):
    listing = subprocess.run(["nm", "--demangle", path], check=True, capture_output=True, text=True).stdout
    for line in listing.splitlines():
        match = DEFINED.match(line)
        if not match or match.group(2) in HARMLESS:
            continue
        name = match.group(2)
        # Highway puts its functions into a namespace per instruction set as well.
        if f"anvil::{level}::" not in name and "hwy::N_" not in name:
            yield f"{match.group(1)} {name}"


def main():
    level, paths = sys.argv[1], sys.argv[2:]
    found = 0
    for path in paths:
        for symbol in offenders(level, path):
            print(f"{path}: {symbol}")
            found += 1
    print(f"{level}: {len(paths)} objects, {found} symbols without the name of the level")
    return 1 if found or not paths else 0


if __name__ == "__main__":
    sys.exit(main())
