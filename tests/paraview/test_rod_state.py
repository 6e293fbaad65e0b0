#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Opens a series and the states of paraview_states/ with ParaView.

Usage: test_rod_state.py WRITE_MUSHROOM, the program that writes a series. ParaView shows an empty scene and returns 0
for files that it cannot read, so every test asks what was read and what was drawn.
"""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
TOP = HERE.parent.parent
STATES = TOP / "paraview_states"
ACROSS = 8
FRAMES = 5
PARTICLES = 5 * ACROSS**3
WRITER = None  # set from the command line


def pvbatch(script, *arguments):
    finished = subprocess.run([TOP / "scripts" / "pvbatch", script, *map(str, arguments)], capture_output=True, text=True)
    if finished.returncode != 0:
        raise AssertionError(f"pvbatch {script} returned {finished.returncode}:\n{finished.stdout}{finished.stderr}")
    return finished.stdout


class RodState(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.result = self.folder / "result"
        self.result.mkdir()
        subprocess.run([WRITER, self.result, str(ACROSS), str(FRAMES)], check=True)
        # The state that is shipped asks for a result of this scene.
        (self.result / "mushroom.pvd").rename(self.result / "rod_square.pvd")

    def inspect(self, *arguments):
        report = self.folder / "report.json"
        report.unlink(missing_ok=True)
        pvbatch(HERE / "inspect_with_paraview.py", report, *arguments)
        return json.loads(report.read_text())

    def check_series(self, report):
        expected = [80e-6 * i / (FRAMES - 1) for i in range(FRAMES)]
        self.assertEqual(len(report["times"]), FRAMES)
        for time, right in zip(report["times"], expected):
            self.assertAlmostEqual(time, right, delta=1e-18)  # a rounding of 80e-6
        self.assertEqual(report["points"], [PARTICLES] * FRAMES)
        self.assertEqual(report["cells"], [PARTICLES] * FRAMES)

    def check_picture(self, report):
        # Rod, wall and colour bar cover about a sixth of the picture. Red is the most deformed part, the foot.
        self.assertGreater(report["drawn_share"], 0.08)
        self.assertLess(report["drawn_share"], 0.4)
        self.assertGreater(report["red_share"], 0.002)
        self.assertLess(report["drawn_box"][0], 0.4)
        self.assertGreater(report["drawn_box"][2], 0.9)  # the colour bar

    def test_series_opens_with_its_times_and_particles(self):
        report = self.inspect("series", self.result / "rod_square.pvd")
        self.check_series(report)
        self.assertEqual(report["arrays"]["plastic_strain"], 1)
        self.assertEqual(report["arrays"]["velocity"], 3)
        self.assertEqual(report["arrays"]["stress"], 6)
        self.assertEqual(report["stress_components"], ["XX", "YY", "ZZ", "XY", "YZ", "XZ"])

    def test_python_state_draws_the_result_it_is_given(self):
        report = self.inspect("python_state", STATES / "rod.py", self.result)
        self.check_series(report)
        self.check_picture(report)

    def test_new_state_file_loads_after_the_result_moved(self):
        state = self.folder / "rod.pvsm"
        pvbatch(STATES / "make_pvsm.py", self.result, state)
        moved = self.folder / "moved"
        self.result.rename(moved)
        report = self.inspect("state_file", state, moved)
        self.check_series(report)
        self.check_picture(report)

    def test_shipped_state_file_draws_any_result(self):
        report = self.inspect("state_file", STATES / "rod.pvsm", self.result)
        self.check_series(report)
        self.check_picture(report)


if __name__ == "__main__":
    WRITER = sys.argv.pop(1)
    unittest.main()
