#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Opens results and the states of paraview_states/ with ParaView.

Usage: test_states.py WRITE_MUSHROOM, the program that writes the series of a rod. ParaView shows an empty scene and
returns 0 for files that it cannot read, so every test asks what was read and what was drawn.
"""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "render"))
import flat_result

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


class StateTest(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.result = self.folder / "result"

    def write_rod(self):
        self.result.mkdir()
        subprocess.run([WRITER, self.result, str(ACROSS), str(FRAMES)], check=True)
        # The state that is shipped asks for a result of this scene.
        (self.result / "mushroom.pvd").rename(self.result / "rod_square.pvd")
        flat_result.write_history(self.result, 80e-6)
        return [80e-6 * i / (FRAMES - 1) for i in range(FRAMES)], PARTICLES

    def inspect(self, *arguments):
        report = self.folder / "report.json"
        report.unlink(missing_ok=True)
        pvbatch(HERE / "inspect_with_paraview.py", report, *arguments)
        return json.loads(report.read_text())

    def check_series(self, report, times, particles):
        self.assertEqual(len(report["times"]), len(times))
        for time, right in zip(report["times"], times):
            self.assertAlmostEqual(time, right, delta=1e-12 * times[-1])  # a rounding
        self.assertEqual(report["points"], [particles] * len(times))
        self.assertEqual(report["cells"], [particles] * len(times))

    def check_picture(self, report, charts, unit, energy):
        # Particles, wall and colour bar; an empty view or a black one is outside.
        self.assertGreater(report["drawn_share"], 0.02)
        self.assertLess(report["drawn_share"], 0.6)
        self.assertGreater(report["colored_share"], 0.004)
        self.assertGreater(report["drawn_box"][2], 0.85)  # the colour bar
        self.assertIn(unit, report["time_text"])
        self.assertEqual([chart["title"] for chart in report["charts"]], charts)
        for chart in report["charts"]:
            self.assertGreater(chart["colored_share"], 0.002, chart)  # curves
        self.assertEqual(report["charts"][-1]["left_axis"], f"energy ({energy})")

    def check_state(self, state, written, charts, *units):
        """As Python, and as the .pvsm that is shipped, with a result that lies elsewhere."""
        report = self.inspect("python_state", STATES / f"{state}.py", self.result)
        self.check_series(report, *written)
        self.check_picture(report, charts, *units)
        self.check_moved(STATES / f"{state}.pvsm", written, charts, *units)

    def check_moved(self, state_file, written, charts, *units):
        moved = self.folder / "moved"
        self.result.rename(moved)
        report = self.inspect("state_file", state_file, moved)
        self.check_series(report, *written)
        self.check_picture(report, charts, *units)
        moved.rename(self.result)

    def test_series_opens_with_its_times_and_particles(self):
        written = self.write_rod()
        report = self.inspect("series", self.result / "rod_square.pvd")
        self.check_series(report, *written)
        self.assertEqual(report["arrays"]["plastic_strain"], 1)
        self.assertEqual(report["arrays"]["velocity"], 3)
        self.assertEqual(report["arrays"]["stress"], 6)
        self.assertEqual(report["stress_components"], ["XX", "YY", "ZZ", "XY", "YZ", "XZ"])

    def test_rod(self):
        written = self.write_rod()
        self.check_state("rod", written, ["History"], "µs", "J")

    def test_new_state_file_loads_after_the_result_moved(self):
        written = self.write_rod()
        made = self.folder / "made.pvsm"
        pvbatch(STATES / "make_pvsm.py", STATES / "rod.py", self.result, made)
        self.check_moved(made, written, ["History"], "µs", "J")

    def test_plate(self):
        written = flat_result.write_result(self.result, "plate", "plate_perfect")
        self.check_state("plate", written, ["Axial stress", "History"], "µs", "J/m²")

    def test_shell(self):
        written = flat_result.write_result(self.result, "shell", "be_shell")
        self.check_state("shell", written, ["History"], "µs", "J/m")

    def test_water(self):
        written = flat_result.write_result(self.result, "water", "water_column")
        self.check_state("fluid", written, ["History"], " s", "J/m")

    def test_soil(self):
        written = flat_result.write_result(self.result, "soil", "soil_collapse")
        report = self.inspect("python_state", STATES / "fluid.py", self.result)
        self.check_series(report, *written)
        self.check_picture(report, ["History"], " s", "J/m")

    def test_says_where_it_looked(self):
        with self.assertRaisesRegex(AssertionError, "expected a .pvd file"):
            pvbatch(STATES / "rod.py", self.folder)


if __name__ == "__main__":
    WRITER = sys.argv.pop(1)
    unittest.main()
