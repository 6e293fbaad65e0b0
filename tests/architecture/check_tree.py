#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks what the compiler does not: the layers, the licence line and paths that exist on one machine only.

Usage: check_tree.py SOURCE_DIR; prints each offence as file:line and returns 1 when there is one.
"""

import pathlib
import re
import sys

IGNORED_FOLDERS = {".git", "results", "__pycache__"}
SOURCE_SUFFIXES = {".cpp", ".hpp", ".in", ".cmake", ".py", ".sh"}
SOURCE_NAMES = {"CMakeLists.txt", ".clang-format", ".clang-tidy"}
SCRIPT_FOLDERS = {"scripts", ".ci"}
LICENCE = re.compile(r"^(//|#) SPDX-License-Identifier: BSD-3-Clause$")
VTK_INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]vtk\w*\.h')
VTK_IO_INCLUDE = re.compile(r'^\s*#\s*include\s*[<"](\.\./)*vtk_io/')
# A slash in front of a usual top folder, unless the word goes on or the slash belongs to a longer path or an address.
MACHINE_PATH = re.compile(r"(?<![\w./}~-])/(work|tmp|root|home|mnt|Users)/[\w.-]")
# Where X servers put their sockets, on every machine.
SHARED_PATH = "/tmp/.X11-unix"
# Tests of vtk_io look at its output through VTK.
FOLDERS_WITH_VTK = ("vtk_io", "tests/unit/vtk_io", "tests/render")


def files_of(folder):
    for path in sorted(folder.iterdir()):
        if path.is_dir():
            is_build = path.name == "build" or (path / "CMakeCache.txt").exists()
            if path.name not in IGNORED_FOLDERS and not is_build:
                yield from files_of(path)
        elif path.is_file():
            yield path


def text_of(path):
    try:
        return path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        return None  # pictures and the like


def is_source(relative):
    return relative.suffix in SOURCE_SUFFIXES or relative.name in SOURCE_NAMES or relative.parts[0] in SCRIPT_FOLDERS


def layer_offence(folder, line):
    if VTK_INCLUDE.match(line) and not folder.startswith(FOLDERS_WITH_VTK):
        return "includes VTK, which only vtk_io may"
    if VTK_IO_INCLUDE.match(line) and folder.startswith("lib"):
        return "includes vtk_io, which lies above lib"
    return None


def offences_of(relative, text):
    lines = text.splitlines()
    if is_source(relative):
        first = lines[1:2] if lines and lines[0].startswith("#!") else lines[:1]
        if not first or not LICENCE.match(first[0]):
            yield 1, "the first line is not the SPDX line"
    for number, line in enumerate(lines, start=1):
        offence = layer_offence(relative.parent.as_posix(), line)
        if offence:
            yield number, offence
        if MACHINE_PATH.search(line.replace(SHARED_PATH, "")):
            yield number, "names a path of one machine"


def main():
    top = pathlib.Path(sys.argv[1])
    own = pathlib.Path(__file__).resolve()
    checked = 0
    found = 0
    for path in files_of(top):
        text = text_of(path)
        if text is None or path.resolve() == own:
            continue
        checked += 1
        relative = path.relative_to(top)
        for number, offence in offences_of(relative, text):
            print(f"{relative}:{number}: {offence}")
            found += 1
    print(f"{checked} files checked, {found} offences")
    return 1 if found or checked < 10 else 0


if __name__ == "__main__":
    sys.exit(main())
