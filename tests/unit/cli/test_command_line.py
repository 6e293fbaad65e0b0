# SPDX-License-Identifier: BSD-3-Clause
"""The program as a user meets it: exit codes, messages, and what it leaves behind. Usage: test_command_line.py ANVIL"""
import json
import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest

ANVIL = ""

# Forty particles for a few steps: the shortest scene that goes through every part of a run.
SCENE = """
title = "Short bar"
[domain]
dimension = 1
[discretisation]
spacing = 0.5e-3
[shock]
method = "artificial_viscosity"
[time]
end = 2e-6
[[body]]
name = "bar"
shape = { type = "interval", min = 0, max = 20e-3 }
material = "steel_elastic"
velocity = [-10]
[[boundary]]
name = "wall"
type = "rigid_wall"
point = [0]
normal = [1]
[output]
interval = 0.5e-6
format = "hdf5"
"""


# The same bar at two spacings, and at one that does not divide it.
STUDY = """
title = "Short bar at several spacings"
report = "orders"
[[grid]]
scene = "bar.toml"
times = [1e-6, 2e-6]
measures = ["stress_l1"]
[[grid.axis]]
key = "discretisation.spacing"
values = [1e-3, 0.5e-3, 0.3e-3]
"""


class CommandLine(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.scene = self.folder / "bar.toml"
        self.scene.write_text(SCENE)
        self.result = self.folder / "result"

    def tearDown(self):
        self.temporary.cleanup()

    def anvil(self, *arguments):
        return subprocess.run([ANVIL, *map(str, arguments)], capture_output=True, text=True, cwd=self.folder)

    def run_scene(self, *arguments):
        return self.anvil("run", self.scene, "-o", self.result, *arguments)

    def expect(self, outcome, code, *words):
        self.assertEqual(outcome.returncode, code, outcome.stdout + outcome.stderr)
        for word in words:
            self.assertIn(word, outcome.stdout + outcome.stderr)

    def expect_error(self, outcome, code, *words):
        self.expect(outcome, code, *words)
        self.assertTrue(outcome.stderr.startswith("anvil: error: "), outcome.stderr)
        self.assertNotIn("terminate called", outcome.stderr)


class Help(CommandLine):
    def test_finds_a_bundled_scene_beside_a_result_of_its_name(self):
        (self.folder / "thin_rod").mkdir()
        self.assertEqual(self.anvil("check", "thin_rod").returncode, 0)

    def test_help_lists_every_subcommand_and_each_has_its_own(self):
        outcome = self.anvil("--help")
        self.expect(outcome, 0, "Usage: anvil", "Exit codes")
        names = [line.split()[0] for line in outcome.stdout.splitlines() if line.startswith("  ") and line[2].islower()]
        names.remove("anvil")
        self.assertIn("run", names)
        for name in names:
            self.expect(self.anvil(name, "--help"), 0, f"Usage: anvil {name}", "--help")

    def test_version(self):
        self.assertRegex(self.anvil("--version").stdout, r"^anvil \d+\.\d+\.\d+ \(")

    def test_full_device_is_an_error(self):
        with open("/dev/full", "w") as full:
            outcome = subprocess.run([ANVIL, "--help"], stdout=full, stderr=subprocess.PIPE, text=True)
        self.assertEqual(outcome.returncode, 2)


class Usage(CommandLine):
    def test_no_subcommand(self):
        self.expect_error(self.anvil(), 1, "--help")

    def test_unknown_subcommand_names_the_nearest(self):
        self.expect_error(self.anvil("compar"), 1, "did you mean 'compare'?")

    def test_unknown_option_names_the_nearest(self):
        self.expect_error(self.run_scene("--overwrit"), 1, "did you mean '--overwrite'?")

    def test_missing_and_surplus_arguments(self):
        self.expect_error(self.anvil("run"), 1, "SCENE is missing")
        self.expect_error(self.anvil("check", self.scene, "more"), 1, "too many arguments")
        self.expect_error(self.anvil("run", self.scene, "-o"), 1)

    def test_impossible_numbers_of_threads(self):
        for threads in ("0", "-1", "many", "1e9", "99999999999999999999"):
            self.expect_error(self.run_scene("--threads", threads), 1, "threads")
        self.assertFalse(self.result.exists())

    def test_unknown_list(self):
        self.expect_error(self.anvil("list", "kernel"), 1, "did you mean 'kernels'?")


class Scenes(CommandLine):
    def test_check_says_fine(self):
        self.expect(self.anvil("check", self.scene), 0, "scene is fine", "40 particles")

    def test_check_names_file_line_and_key(self):
        self.scene.write_text(SCENE.replace("spacing", "spacng"))
        self.expect_error(self.anvil("check", self.scene), 1, "bar.toml:6", "spacing")

    def test_missing_scene(self):
        self.expect_error(self.anvil("check", "absent.toml"), 1, "absent.toml")
        self.expect_error(self.anvil("check", "rod_squar"), 1, "rod_square")

    def test_override(self):
        self.expect(self.anvil("check", self.scene, "--set", "discretisation.spacing=1e-3"), 0, "20 particles")
        self.expect_error(self.anvil("check", self.scene, "--set", "discretisation.spacing=-1"), 1, "spacing")

    def test_explain_shows_terms_fields_and_cost(self):
        self.expect(self.anvil("explain", self.scene), 0, "momentum", "density", "bytes per particle", "first time step")

    def test_lists(self):
        self.expect(self.anvil("list"), 0, "rod_square", "copper", "cubic_spline", "rigid_wall", "j2")
        self.expect(self.anvil("list", "keys"), 0, "time.end", "discretisation.spacing")


class Runs(CommandLine):
    def test_a_study_leaves_a_table_and_a_figure(self):
        study = self.folder / "spacings.toml"
        study.write_text(STUDY)
        self.expect(self.anvil("study", study, "-o", self.result), 0, "order", "refused", "3 of 3 runs")
        rows = (self.result / "results.csv").read_text().splitlines()
        self.assertEqual(len(rows), 1 + 2 + 2 + 1)
        self.assertTrue(rows[1].startswith("1,bar,0.001,1e-06,"))
        for name in ("results.h5", "study.json", "runs.jsonl", "spacings.svg"):
            self.assertTrue((self.result / name).exists(), name)
        # Started again it has nothing left to run but what was refused.
        self.expect(self.anvil("study", study, "-o", self.result), 0, "2 of 3 runs are there already")

    def test_a_study_with_bad_input_leaves_no_folder(self):
        self.expect_error(self.anvil("study", "kernel_table", "-o", self.result), 1, "did you mean 'kernel_tables'")
        self.expect_error(self.anvil("study", "plate_table", "-o", self.result, "--set", "time.flow=1"), 1, "flow")
        self.expect_error(self.anvil("study", "plate_table", "-o", self.result, "--set", "shock.method=none"), 1, "axis")
        self.expect_error(self.anvil("study", "plate_table", "-o", self.result, "--threads", "0"), 1, "--threads")
        self.assertFalse(self.result.exists())

    def test_a_run_leaves_what_it_promises(self):
        self.expect(self.run_scene(), 0, "finished")
        frames = sorted(path.name for path in (self.result / "frames").iterdir())
        self.assertEqual(frames, [f"bar_{index:06}.h5" for index in range(5)])
        record = json.loads((self.result / "run.json").read_text())
        self.assertEqual(record["status"], "finished")
        self.assertEqual(record["particles"], 40)
        self.assertTrue((self.result / f"checkpoint_{record['steps']}.h5").exists())
        header = (self.result / "history.csv").read_text().splitlines()[0]
        self.assertTrue(header.startswith("time [s],step,time_step [s],mass [kg"), header)

    def test_provenance_names_neither_machine_nor_user(self):
        self.run_scene()
        text = (self.result / "run.json").read_text()
        self.assertNotIn(os.uname().nodename, text)
        self.assertNotIn(str(self.folder), text)

    def test_info_reads_everything_a_run_leaves(self):
        self.run_scene()
        for name in ("", "run.json", "frames/bar_000004.h5", *(p.name for p in self.result.glob("checkpoint_*.h5"))):
            self.expect(self.anvil("info", self.result / name), 0, "version", "commit")
        self.expect_error(self.anvil("info", self.result / "absent"), 1, "absent")
        self.expect_error(self.anvil("info", self.result / "history.csv"), 1, "history.csv")

    def test_quiet(self):
        outcome = self.run_scene("--quiet")
        self.assertEqual((outcome.returncode, outcome.stdout, outcome.stderr), (0, "", ""))

    def test_bad_input_leaves_no_folder(self):
        self.expect_error(self.run_scene("--set", "time.end=-1"), 1, "time.end")
        self.expect_error(self.run_scene("--set", "domain.dimension=3"), 1)
        self.assertFalse(self.result.exists())

    def test_a_different_result_is_not_overwritten_unless_told(self):
        self.run_scene()
        before = (self.result / "history.csv").read_text()
        self.expect_error(self.run_scene("--set", "time.end=1e-6"), 1, "--overwrite", "Short bar")
        self.assertEqual((self.result / "history.csv").read_text(), before)
        self.expect(self.run_scene(), 0)  # the same scene again
        self.expect(self.run_scene("--set", "time.end=1e-6", "--overwrite"), 0)
        self.assertEqual(len(list((self.result / "frames").iterdir())), 3)

    def test_foreign_folders_are_never_touched(self):
        self.result.mkdir()
        (self.result / "thesis.tex").write_text("years of work")
        self.expect_error(self.run_scene("--overwrite"), 1, "no result of anvil")
        self.assertEqual([path.name for path in self.result.iterdir()], ["thesis.tex"])

    def test_folder_that_cannot_be_made(self):
        outcome = self.anvil("run", self.scene, "-o", "/proc/result")
        self.expect_error(outcome, 2, "/proc/result")

    def test_any_number_of_threads_gives_the_same_bits(self):
        self.run_scene("--threads", "1")
        one = (self.result / "history.csv").read_bytes()
        self.run_scene("--threads", "3")
        self.assertEqual((self.result / "history.csv").read_bytes(), one)


class Failures(CommandLine):
    def test_full_disk(self):
        def limit():  # as a full disk: writing beyond it fails, here without the signal that would end the program
            resource.setrlimit(resource.RLIMIT_FSIZE, (6000, 6000))
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)

        command = [ANVIL, "run", self.scene, "-o", self.result, "--quiet"]
        outcome = subprocess.run(command, capture_output=True, text=True, preexec_fn=limit, restore_signals=False)
        self.expect_error(outcome, 2, "cannot write", str(self.result))
        left = [path.name for path in self.result.rglob("*.part")]
        self.assertEqual(left, [])
        self.assertEqual(json.loads((self.result / "run.json").read_text())["status"], "failed")

    def test_a_run_that_blows_up(self):
        # Seven times the sound speed: the bar is squeezed until its steps vanish.
        self.expect_error(self.run_scene("--quiet", "--set", "body.bar.velocity=[-40000]"), 3, "last good frame")
        record = json.loads((self.result / "run.json").read_text())
        self.assertEqual(record["status"], "failed")
        self.assertIn("last good frame", record["reason"])
        self.expect(self.anvil("info", self.result / "frames/bar_000000.h5"), 0)


class Restarts(CommandLine):
    def test_a_longer_run_from_the_last_checkpoint(self):
        self.run_scene()
        checkpoint = next(self.result.glob("checkpoint_*.h5"))
        self.expect(self.anvil("run", "--restart", checkpoint, "--set", "time.end=3e-6"), 0, "finished at 3e-06")
        self.assertEqual(len(list((self.result / "frames").iterdir())), 7)

    def test_what_cannot_go_with_a_restart(self):
        self.run_scene()
        checkpoint = next(self.result.glob("checkpoint_*.h5"))
        self.expect_error(self.anvil("run", "--restart", checkpoint, "-o", "other"), 1, "its checkpoint")
        self.expect_error(self.anvil("run", self.scene, "--restart", checkpoint), 1, "its checkpoint")
        self.expect_error(self.anvil("run", "--restart", checkpoint, "--set", "time.cfl=0.1"), 1, "time.cfl")
        self.expect_error(self.anvil("run", "--restart", checkpoint, "--set", "time.end=1e-6"), 1, "after time.end")

    def test_what_is_no_checkpoint(self):
        self.run_scene()
        self.expect_error(self.anvil("run", "--restart", self.scene), 1, "bar.toml")
        self.expect_error(self.anvil("run", "--restart", self.result / "frames/bar_000001.h5"), 1, "anvil frame")
        checkpoint = next(self.result.glob("checkpoint_*.h5"))
        checkpoint.write_bytes(checkpoint.read_bytes()[:-100])
        self.expect_error(self.anvil("run", "--restart", checkpoint), 1, checkpoint.name)


class ExactAndPlot(CommandLine):
    def test_the_exact_solution_is_a_table_with_units(self):
        result = self.anvil("exact", "plate_perfect", "--time", "8e-6", "--points", "81")
        self.expect(result, 0, "# Elastic-plastic pulse", "finite strain", "initial_position [m],stress_xx [Pa]")
        rows = [line.split(",") for line in result.stdout.splitlines()[2:]]
        self.assertEqual(len(rows), 81)
        self.assertAlmostEqual(float(rows[30][1]), -5e9, delta=1.0)  # the loaded plateau, 16 to 43 mm
        self.expect(self.anvil("exact", "plate_perfect", "--time", "8e-6", "--strain", "small"), 0, "small strain")

    def test_mistakes_about_the_exact_solution(self):
        self.expect_error(self.anvil("exact", "plate_perfect"), 1, "--time")
        self.expect_error(self.anvil("exact", "plate_perfect", "--time", "-1"), 1, "zero or more")
        self.expect_error(self.anvil("exact", "plate_perfect", "--time", "1e-6", "--points", "1"), 1, "--points")
        self.expect_error(self.anvil("exact", "rod_square", "--time", "1e-6"), 1, "3 dimensions")
        self.expect_error(self.anvil("exact", "bar_elastic_1d", "--time", "8e-6"), 1, "leave the wall")

    def test_a_figure_as_svg(self):
        self.run_scene()
        figure = self.folder / "figure.svg"
        self.expect(self.anvil("plot", self.result, "--field", "stress.xx", "--history", "kinetic_energy",
                               "-o", figure), 0, "figure.svg")
        self.assertEqual(figure.read_text().count("<polyline clip-path="), 2)

    def test_mistakes_about_figures(self):
        self.run_scene()
        self.expect_error(self.anvil("plot", self.result), 1, "--field")
        self.expect_error(self.anvil("plot", self.result, "--field", "velocty.x"), 1, "velocity.x")
        self.expect_error(self.anvil("plot", self.result, "--field", "pressure", "--times", "1"), 1, "no frame at 1 s")
        self.expect_error(self.anvil("plot", self.result, "--field", "pressure", "--unit", "mm"), 1, "is in Pa")
        self.expect_error(self.anvil("plot", self.result, "--field", "pressure", "-o", "a.gif"), 1, ".png nor .svg")
        self.expect_error(self.anvil("plot", self.result, "--figure", "plate_perfekt"), 1, "plate_perfect")


    def test_figures_of_single_frames_and_their_parts(self):
        self.run_scene()
        frame = sorted((self.result / "frames").iterdir())[-1]
        figure = self.folder / "figure.svg"
        reference = self.folder / "reference.csv"
        reference.write_text("place [mm],stress [MPa]\n0,-1\n20,0\n")
        self.expect(self.anvil("plot", frame, "--field", "stress.xx", "--where", "position.x < 10e-3",
                               "--reference", f"{reference}:place:stress", "-o", figure), 0)
        self.assertEqual(figure.read_text().count("<polyline clip-path="), 2)
        self.expect(self.anvil("plot", self.result, "--field", "density", "--line", "0,0,0:0.02,0,0", "-o", figure), 0)
        self.assertIn("Distance [mm]", figure.read_text())
        self.expect(self.anvil("plot", self.result, "--history", "step", "--log", "y", "-o", figure), 0)
        self.assertIn("10²", figure.read_text())
        self.expect_error(self.anvil("plot", frame, "--history", "step"), 1, "has no history.csv")
        self.expect_error(self.anvil("plot", frame, "--field", "density", "--where", "position.x < -1"), 1, "no particle")
        self.expect_error(self.anvil("plot", frame, "--field", "density", "--line", "1,0,0:2,0,0"), 1, "no particles")
        self.expect_error(self.anvil("plot", frame, "--field", "density", "--line", "1,0,0"), 1, "two points")
        self.expect_error(self.anvil("plot", frame, "--field", "density", "--reference", "a.csv"), 1, "FILE:X:Y")
        self.expect_error(self.anvil("plot", frame, "--field", "density", "--log", "z"), 1, "x, y or xy")
        self.expect_error(self.anvil("plot", self.folder / "nowhere", "--field", "density"), 1, "no result")


class Sampling(CommandLine):
    def table(self, path):
        comment, header, *rows = path.read_text().splitlines()
        self.assertTrue(comment.startswith("# bar, t = "))
        return header.split(","), [[float(cell) for cell in row.split(",")] for row in rows]

    def test_a_line_as_csv(self):
        self.run_scene()
        table = self.folder / "line.csv"
        self.expect(self.anvil("sample", self.result, "--line", "0.001,0,0:0.019,0,0", "--points", "19", "--order", "1",
                               "--time", "0", "--field", "initial_position", "--field", "velocity.x*2", "-o", table),
                    0, "line.csv")
        header, rows = self.table(table)
        self.assertEqual(header, ["distance [m]", "x [m]", "y [m]", "z [m]", "initial_position.x [m]",
                                  "initial_position.y [m]", "initial_position.z [m]", "velocity.x*2", "filling"])
        self.assertEqual(len(rows), 19)
        for i, row in enumerate(rows):
            # At time 0 the initial position is the position, a linear field, and the velocity is constant.
            self.assertAlmostEqual(row[0], 1e-3 * i, delta=1e-15)
            self.assertAlmostEqual(row[4], row[1], delta=1e-15)
            self.assertAlmostEqual(row[7], -20.0, delta=1e-12)
            self.assertAlmostEqual(row[8], 1.0, delta=0.02)

    def test_outside_of_the_bodies_there_is_no_value(self):
        self.run_scene()
        table = self.folder / "line.csv"
        self.anvil("sample", self.result, "--line", "0.01,0,0:0.03,0,0", "--points", "3", "--field", "density", "-o", table)
        _, rows = self.table(table)
        self.assertAlmostEqual(rows[0][4], 7890.0, delta=100.0)
        self.assertNotEqual(rows[2][4], rows[2][4])

    def test_mistakes_about_samples(self):
        self.run_scene()
        self.expect_error(self.anvil("sample", self.result), 1, "--line A:B or --plane")
        self.expect_error(self.anvil("sample", self.result, "--line", "0,0,0"), 1, "two points")
        self.expect_error(self.anvil("sample", self.result, "--line", "0,0,0:0,0,0"), 1, "same point")
        self.expect_error(self.anvil("sample", self.result, "--line", "1,0,0:2,0,0"), 1, "none of the points")
        self.expect_error(self.anvil("sample", self.result, "--plane", "w=1"), 1, "z=0.01")
        line = ("--line", "0,0,0:0.02,0,0")
        self.expect_error(self.anvil("sample", self.result, *line, "--field", "velocty"), 1, "'velocity'")
        self.expect_error(self.anvil("sample", self.result, *line, "--order", "2"), 1, "0 or 1")
        self.expect_error(self.anvil("sample", self.result, *line, "--points", "1"), 1, "2 to")
        self.expect_error(self.anvil("sample", self.result, *line, "--smoothing-length", "-1"), 1, "above 0")
        self.expect_error(self.anvil("sample", self.result, *line, "--frame", "99"), 1, "0 to 4")
        self.expect_error(self.anvil("sample", self.result, *line, "--array", "density"), 1, "ANVIL=FILE")
        self.expect_error(self.anvil("sample", self.result, *line, "--array", "density=rho"), 1, "no array 'rho'")
        self.expect_error(self.anvil("sample", self.result, *line, "-o", "a.txt"), 1, "a.txt")


class Fields(CommandLine):
    def arrays(self, *settings):
        self.expect(self.run_scene("--overwrite", *[part for one in settings for part in ("--set", one)]), 0)
        frames = sorted((self.result / "frames").iterdir())
        text = self.anvil("info", frames[-1]).stdout
        return len(frames), {line.split()[1] for line in text.splitlines() if line.startswith("array")}

    def test_number_of_frames_and_choice_of_fields(self):
        frames, usual = self.arrays()
        self.assertEqual(frames, 5)
        self.assertLessEqual({"particle_id", "body", "velocity", "stress", "smoothing_length"}, usual)
        frames, chosen = self.arrays("output.frames=8", 'output.omit=["stress", "smoothing_length"]',
                                     'output.fields=["mass", "deviatoric_stress"]')
        self.assertEqual(frames, 9)
        self.assertEqual(chosen, usual - {"stress", "smoothing_length"} | {"mass", "deviatoric_stress"})


class Signals(CommandLine):
    def test_interrupt_writes_a_checkpoint_that_goes_on(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            process = subprocess.Popen(
                [ANVIL, "run", self.scene, "-o", self.result, "--overwrite", "--set", "time.end=1e-3"],
                stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
            while not (self.result / "frames/bar_000001.h5").exists():
                self.assertIsNone(process.poll(), "the run ended early")
                time.sleep(0.01)
            process.send_signal(number)
            output, _ = process.communicate(timeout=60)
            self.assertEqual(process.returncode, code)
            self.assertIn("stopped", output)
            record = json.loads((self.result / "run.json").read_text())
            self.assertEqual(record["status"], "stopped")
            checkpoint = self.result / f"checkpoint_{record['steps']}.h5"
            end = record["time"] + 1e-7
            self.expect(self.anvil("run", "--restart", checkpoint, "--set", f"time.end={end!r}"), 0, "finished")
            for path in (self.result / "frames").iterdir():
                path.unlink()


class Comparisons(CommandLine):
    def test_without_a_reference_it_reports_the_balances(self):
        self.run_scene()
        table = self.folder / "table.csv"
        self.expect(self.anvil("compare", self.result, "--csv", table), 0, "momentum_balance", "energy_balance")
        names = [line.split(",")[0] for line in table.read_text().splitlines()]
        self.assertEqual(names[0], "quantity")
        self.assertIn("momentum_balance", names)

    def test_exit_code_follows_the_tolerance(self):
        for allowed, code in (("0.5", 0), ("1e-300", 4)):
            self.run_scene("--overwrite", "--set", f"compare.tolerance={{ energy_balance = {allowed} }}")
            self.expect(self.anvil("compare", self.result), code, "fine" if code == 0 else "OUTSIDE")

    def test_tolerance_of_nothing_measured(self):
        self.run_scene("--set", "compare.tolerance={ energy_balanc = 0.5 }")
        self.expect_error(self.anvil("compare", self.result), 1, "energy_balance")

    def test_what_is_no_result(self):
        self.expect_error(self.anvil("compare", self.folder), 1, "run.json")


if __name__ == "__main__":
    ANVIL = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
