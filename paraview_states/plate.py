# SPDX-License-Identifier: BSD-3-Clause
"""ParaView state: the axial stress along a plate, the particles as a row of spheres, and the energies.

In ParaView: start it in the top folder of Anvil (or set ANVIL_STATES to this folder), File > Load State, choose this
file; the result is the one in the environment variable ANVIL_RESULT, else results/plate_perfect. On the command line:

    scripts/pvbatch paraview_states/plate.py RESULT [PICTURE.png]

RESULT is a result folder or its .pvd file.
"""

import os
import sys
from pathlib import Path

from paraview.simple import *

HERE = Path(globals().get("__file__", Path(os.environ.get("ANVIL_STATES", "paraview_states")) / "plate.py")).resolve().parent
sys.path.insert(0, str(HERE))
import anvil_paraview as anvil

ARGUMENTS = [argument for argument in getattr(sys, "argv", [])[1:] if not argument.startswith("-")]


def show_profile(particles, beside):
    """Axial stress over the initial position; the chart follows the time of the animation."""
    profile = PlotData(registrationName="profile", Input=particles)
    chart = anvil.add_chart(beside, "Axial stress", "initial position (m)", "stress xx (Pa)", 0.25, below=True)
    display = Show(profile, chart, "XYChartRepresentation")
    anvil.draw_series(display, "initial_position_X", {"stress_XX": "stress xx"})
    return chart


path = anvil.find_series(ARGUMENTS, HERE.parent / "results" / "plate_perfect")
particles, view = anvil.open_series(path)
(x_min, x_max, *_), low, high = anvil.extent_over_time(particles, "stress", 0)
# Larger than they are: a plate of a thousand particles would else be a hair line.
spheres = anvil.show_spheres(particles, view, 0.015 * (x_max - x_min), "Plain circle")
anvil.color_by(spheres, view, "stress", "XX", anvil.SIGNED, low, anvil.rounded_up(max(-low, high)), "stress xx (Pa)")
anvil.show_time(particles, view)
anvil.look_at_plane(view, [x_min, x_max, 0.0, 0.0])
view.CameraParallelScale = 0.13 * (x_max - x_min)  # a wide, low view
view.OrientationAxesVisibility = 0
profile = show_profile(particles, view)
anvil.show_history(path, profile, anvil.ENERGIES, "energy", 0.5)
anvil.finish(view, ARGUMENTS)
