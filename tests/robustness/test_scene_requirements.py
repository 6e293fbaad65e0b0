# SPDX-License-Identifier: BSD-3-Clause
"""Holds what every bundled scene is made of: docs/scene_requirements.md. Usage: test_scene_requirements.py ANVIL

A term or a field that turns up where nothing asks for it fails here. ANVIL_UPDATE_PAGES=1 writes the page anew.
"""
import os
import pathlib
import re
import subprocess
import sys

ANVIL = sys.argv[1]
SOURCE = pathlib.Path(__file__).resolve().parents[2]
PAGE = SOURCE / "docs" / "scene_requirements.md"

HEADING = """# What each scene requires

Made from `anvil explain` of every bundled scene; a test fails when this page and the program differ. A step consists of
the terms, in this order; a particle carries the fields in the store and the records that pair loops read, and nothing else. Bytes are per
particle without the neighbour list, those of the fields alone in parentheses. A term in several bodies is named once.

| scene | terms | fields | records | bytes |
|---|---|---|---|---|
"""


def explain(scene):
    return subprocess.run([ANVIL, "explain", scene], check=True, capture_output=True, text=True).stdout


def section(text, begin, end):
    return text.split(begin, 1)[1].split(end, 1)[0].strip().split("\n")


def requirements(scene):
    """Names of terms, (name, bytes) of fields, (name, bytes) of records."""
    text = explain(scene)
    terms = [re.match(r"\s*\d+\.\s+(\w+)", line)[1] for line in section(text, "A step is made of\n", "\n\n")]
    carried = []
    for line in section(text, "A particle carries\n", "\n\n")[1:]:
        name, size = re.match(r"(.+?)\s\s+\S+\s+(\d+)\s", line).groups()
        carried.append((name, int(size)))
    packed = [item for item in carried if " " in item[0]]
    return list(dict.fromkeys(terms)), [item for item in carried if item not in packed], packed


def row(scene, terms, fields, records):
    in_fields, in_records = sum(size for _, size in fields), sum(size for _, size in records)
    names = [", ".join(name.removesuffix(" record") for name, _ in items) for items in (fields, records)]
    return f"| {scene} | {', '.join(terms)} | {names[0]} | {names[1]} | {in_fields + in_records} ({in_fields}) |\n"


def main():
    page = HEADING
    for file in sorted((SOURCE / "data" / "scenes").glob("*.toml")):
        terms, fields, records = requirements(file.stem)
        if file.stem == "bar_elastic_1d":
            doubles = sum(size for _, size in fields) / 8
            assert doubles <= 15, f"an elastic line carries {doubles} doubles a particle"
        page += row(file.stem, terms, fields, records)
    if "ANVIL_UPDATE_PAGES" in os.environ:
        PAGE.write_text(page)
    expected, found = PAGE.read_text().split("\n"), page.split("\n")
    different = [f"- {a}\n+ {b}" for a, b in zip(expected, found) if a != b]
    assert expected == found, "the page and the program differ; see the head of this test:\n" + "\n".join(different)


main()
