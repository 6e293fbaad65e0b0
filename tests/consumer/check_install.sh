#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Usage: check_install.sh BUILD_DIR CXX_COMPILER
#
# Installs a build, moves the installed tree elsewhere, and checks that the program finds its bundled scenes there and
# that a program of somebody else builds against the library and runs.
set -euo pipefail

build=$1
compiler=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset ANVIL_DATA

cmake --install "$build" --prefix "$work/first" >/dev/null
mv "$work/first" "$work/moved"
prefix=$work/moved

cd "$work"
"$prefix/bin/anvil" list | grep rod_square
"$prefix/bin/anvil" check rod_square

cmake -S "$here/program" -B "$work/build" -G Ninja -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER="$compiler" \
  -D CMAKE_PREFIX_PATH="$prefix" >"$work/configure.log" || { cat "$work/configure.log"; exit 1; }
cmake --build "$work/build"
# A program outside the prefix has to be told where the bundled files are.
ANVIL_DATA=$prefix/share/anvil "$work/build/consumer" "$prefix/share/anvil/scenes/rod_square.toml"

# No installed text (package files above all) may point back to the tree it came from.
top=$(cd "$here/../.." && pwd)
if grep -rIl --fixed-strings -e "$top" -e "$build" "$prefix"; then
  echo "the files above name the source or the build tree" >&2
  exit 1
fi
