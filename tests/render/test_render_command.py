#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""`anvil render` and `anvil sample` as a user meets them. Usage: test_render_command.py ANVIL WRITE_MUSHROOM VTK_PYTHON,
the program, the one that writes the series of a rod, and a Python with VTK's module."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import flat_result

ANVIL, WRITER, PYTHON = "", "", ""
FRAMES = 4
SMALL = ("--size", "400x300")


class RenderCommand(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.rod = self.folder / "rod"
        self.rod.mkdir()
        subprocess.run([WRITER, self.rod, "6", str(FRAMES)], check=True)

    def anvil(self, *arguments, **environment):
        return subprocess.run([ANVIL, *map(str, arguments)], capture_output=True, text=True, cwd=self.folder,
                              env={**os.environ, **environment})

    def expect(self, outcome, code, *words):
        self.assertEqual(outcome.returncode, code, outcome.stdout + outcome.stderr)
        for word in words:
            self.assertIn(word, outcome.stdout + outcome.stderr)

    def expect_picture(self, *arguments):
        picture = self.folder / "picture.png"
        picture.unlink(missing_ok=True)
        self.expect(self.anvil("render", *arguments, "-o", picture, *SMALL), 0, "picture.png")
        self.assertGreater(picture.stat().st_size, 3000)  # an empty white picture has a thousand bytes
        return picture.read_bytes()

    def test_every_kind_of_input_gives_the_same_picture(self):
        last = self.rod / "frames" / f"mushroom_{FRAMES - 1:06d}.vtp"
        pictures = {self.expect_picture(path) for path in (self.rod, self.rod / "mushroom.pvd", last)}
        pictures.add(self.expect_picture(self.rod, "--frame", str(FRAMES - 1)))
        pictures.add(self.expect_picture(self.rod, "--time", "80e-6"))
        self.assertEqual(len(pictures), 1)
        self.assertNotEqual({self.expect_picture(self.rod, "--frame", "0")}, pictures)

    def test_every_view(self):
        views = [(), ("--surface",), ("--no-cut",), ("--view", "section"),
                 ("--section", "z=0.004"), ("--mirror", "x=0.02"), ("--field", "stress.zz", "--colors", "cool_warm"),
                 ("--field", "sqrt(velocity.x^2 + velocity.z^2)"), ("--field", "body"), ("--radius", "0.3"),
                 ("--direction", "1,1,0.2")]
        self.assertEqual(len({self.expect_picture(self.rod, *view) for view in views}), len(views))
        # Particles in space are the rod without the cut.
        self.assertTrue(self.expect_picture(self.rod, "--view", "particles") ==
                        self.expect_picture(self.rod, "--no-cut"))

    def test_mistakes(self):
        self.expect(self.anvil("render", self.rod, "--frame", "9"), 1, "there are 0 to 3")
        self.expect(self.anvil("render", self.rod, "--time", "1"), 1, "no frame at 1 s")
        self.expect(self.anvil("render", self.rod, "--time", "0", "--frame", "0"), 1, "one of them")
        self.expect(self.anvil("render", self.folder / "nowhere"), 1, "no result")
        self.expect(self.anvil("render", self.rod, "--view", "fish"), 1, "rod, particles or section")
        self.expect(self.anvil("render", self.rod, "--colors", "vridis"), 1, "'viridis'")
        self.expect(self.anvil("render", self.rod, "--field", "plastic_strian"), 1, "'plastic_strain'")
        self.expect(self.anvil("render", self.rod, "--section", "z=1"), 1, "does not meet the bodies")
        self.expect(self.anvil("render", self.rod, "--direction", "0,0,1"), 1, "view direction")
        self.expect(self.anvil("render", self.rod, "-o", "rod.gif"), 1, ".png nor .mp4")
        self.expect(self.anvil("render", self.rod, "-o", "rod.mp4", "--frame", "1"), 1, "choose one frame")
        self.expect(self.anvil("render", self.rod, "--array", "plastic_strain=epsilon"), 1, "no array 'epsilon'")
        self.expect(self.anvil("render", self.rod, "-o", "no/such/folder.png", *SMALL), 2, "no/such")

    def test_a_series_shares_its_colors(self):
        self.expect(self.anvil("render", self.rod, "--series", "-o", "all.png", *SMALL), 0, "all_000000.png",
                    "frame 8 of 8")
        self.assertEqual(len(list(self.folder.glob("all_*.png"))), FRAMES)
        first, last = ((self.folder / f"all_{i:06d}.png").read_bytes() for i in (0, FRAMES - 1))
        # The first frame alone has no strain to colour and no wide foot to make room for; the last one has the largest
        # of both, and its outline is as high as the rod was.
        self.assertTrue(first != self.expect_picture(self.rod, "--frame", "0"))
        self.assertTrue(last == self.expect_picture(self.rod))
        self.expect(self.anvil("render", self.rod, "--series", "--every", "2", "-o", "half.png", "--quiet", *SMALL), 0)
        self.assertEqual(len(list(self.folder.glob("half_*.png"))), FRAMES // 2)

    def test_a_film(self):
        if shutil.which("ffmpeg") is None:
            self.skipTest("ffmpeg is not installed")
        self.expect(self.anvil("render", self.rod, "-o", "rod.mp4", "--quiet", "--size", "401x301"), 0, "rod.mp4")
        probe = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries",
                                "stream=nb_read_frames,width,pix_fmt", "-of", "json", "rod.mp4"],
                               capture_output=True, text=True, cwd=self.folder, check=True)
        stream = json.loads(probe.stdout)["streams"][0]
        self.assertEqual(int(stream["nb_read_frames"]), FRAMES)
        self.assertEqual((stream["width"], stream["pix_fmt"]), (402, "yuv420p"))
        self.assertFalse((self.folder / "rod_frames").exists())

    def test_only_the_program_that_draws_loads_what_draws(self):
        libraries = [subprocess.run(["ldd", program], capture_output=True, text=True, check=True).stdout
                     for program in (ANVIL, Path(ANVIL).with_name("anvil-figures"))]
        self.assertEqual(["vtkRendering" in text for text in libraries], [False, True])

    def test_the_program_that_draws_is_missed(self):
        alone = self.folder / "anvil"
        shutil.copy(ANVIL, alone)
        outcome = subprocess.run([alone, "plot", self.rod], capture_output=True, text=True)
        self.expect(outcome, 2, "anvil-figures", "No such file", "install both")

    def test_without_ffmpeg_the_pictures_stay(self):
        # A path with the X server alone.
        programs = self.folder / "programs"
        programs.mkdir()
        for program in ("Xvfb", "xkbcomp", "sh"):
            if (found := shutil.which(program)) is not None:
                (programs / program).symlink_to(found)
        self.expect(self.anvil("render", self.rod, "-o", "rod.mp4", "--quiet", *SMALL, PATH=str(programs)), 0,
                    "ffmpeg is not installed")
        self.assertEqual(len(list((self.folder / "rod_frames").glob("rod_*.png"))), FRAMES)

    def test_files_of_other_programs(self):
        times, count = flat_result.write_result(self.folder / "water", "water", "water_column")
        series = self.folder / "water" / "water_column.pvd"
        single = self.folder / "water" / "frames" / "water_column_000002.vtp"
        foreign = self.folder / "foreign.vtp"
        foreign.write_text(single.read_text().replace('Name="velocity"', 'Name="Vel"').replace(
            'Name="pressure"', 'Name="Press"'))
        known = self.expect_picture(single, "--field", "pressure", "--colors", "water")
        self.assertEqual(known, self.expect_picture(foreign, "--field", "pressure", "--array", "pressure=Press",
                                                    "--colors", "water"))
        self.expect_picture(foreign)  # no array that is known: its first one
        # A plot of the PVD at one of its times, from files that hold none.
        self.expect(self.anvil("plot", series, "--field", "pressure", "--along", "position.y", "--times", times[1],
                               "-o", "water.svg"), 0)
        self.assertEqual((self.folder / "water.svg").read_text().count("<circle"), count + 1)  # and in the legend

    def test_samples_read_back_with_vtk(self):
        plane, line = self.folder / "plane.vti", self.folder / "line.vtp"
        self.expect(self.anvil("sample", self.rod, "--plane", "0,0,0.005:1,1,0", "-o", plane), 0)
        self.expect(self.anvil("sample", self.rod, "--line", "0,0,0.001:0,0,0.02", "--points", "50", "-o", line), 0)
        script = """
import sys, vtk
from vtk.util.numpy_support import vtk_to_numpy
image = vtk.vtkXMLImageDataReader(); image.SetFileName(sys.argv[1]); image.Update(); image = image.GetOutput()
for i in range(0, image.GetNumberOfPoints(), 97):
    x, y, z = image.GetPoint(i)
    assert abs(x + y) < 1e-12, (x, y, z)
strain = vtk_to_numpy(image.GetPointData().GetArray("plastic_strain"))
assert (strain == strain).any() and (strain != strain).any()
line = vtk.vtkXMLPolyDataReader(); line.SetFileName(sys.argv[2]); line.Update(); line = line.GetOutput()
assert line.GetNumberOfPoints() == 50 and line.GetNumberOfLines() == 1
assert line.GetPointData().GetArray("stress").GetComponentName(3) == "XY"
assert abs(line.GetFieldData().GetArray("TimeValue").GetValue(0) - 80e-6) < 1e-15
density = vtk_to_numpy(line.GetPointData().GetArray("density"))
assert abs(density[5:45] - 8930).max() < 1e-6
"""
        subprocess.run([PYTHON, "-c", script, plane, line], check=True)

    def test_many_at_once_without_a_display(self):
        environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
        renders = [subprocess.Popen([ANVIL, "render", str(self.rod), "-o", f"many_{i}.png", *SMALL], cwd=self.folder,
                                    env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
                   for i in range(24)]
        failures = [process.communicate()[1] for process in renders if process.wait() != 0]
        self.assertEqual(failures, [])
        self.assertEqual(len({(self.folder / f"many_{i}.png").read_bytes() for i in range(24)}), 1)


if __name__ == "__main__":
    ANVIL, WRITER, PYTHON = sys.argv[1:4]
    del sys.argv[1:4]
    unittest.main()
