# SPDX-License-Identifier: BSD-3-Clause
"""ParaView state: a deforming body on a wall as spheres coloured by plastic strain, with the time and the energies.

In ParaView: start it in the top folder of Anvil (or set ANVIL_STATES to this folder), File > Load State, choose this
file; the result is the one in the environment variable ANVIL_RESULT, else results/rod_square. On the command line:

    scripts/pvbatch paraview_states/rod.py RESULT [PICTURE.png]

RESULT is a result folder or its .pvd file.
"""

import os
import sys
from pathlib import Path

from paraview.simple import *

HERE = Path(globals().get("__file__", Path(os.environ.get("ANVIL_STATES", "paraview_states")) / "rod.py")).resolve().parent
sys.path.insert(0, str(HERE))
import anvil_paraview as anvil

ARGUMENTS = [argument for argument in getattr(sys, "argv", [])[1:] if not argument.startswith("-")]


def show_wall(particles, view):
    """A square of the wall z = 0, wide enough for the foot."""
    x_min, x_max, y_min, y_max = particles.GetDataInformation().GetBounds()[:4]
    half = 0.6 * max(x_max - x_min, y_max - y_min)
    wall = Plane(registrationName="wall")
    wall.Origin = [-half, -half, 0.0]
    wall.Point1 = [half, -half, 0.0]
    wall.Point2 = [-half, half, 0.0]
    display = Show(wall, view)
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = [0.86, 0.89, 0.92]
    display.Ambient = 1.0
    display.Diffuse = 0.0


def aim(view):
    """Looks at the first frame, the tallest, with room around it for the foot of the last one."""
    scene = GetAnimationScene()
    scene.GoToFirst()
    view.CameraPosition = [0.5, -1.0, 0.4]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    ResetCamera(view)
    view.CameraParallelScale *= 1.3
    scene.GoToLast()


path = anvil.find_series(ARGUMENTS, HERE.parent / "results" / "rod_square")
particles, view = anvil.open_series(path)
spheres = anvil.show_spheres(particles, view, 0.55 * anvil.spacing_of(particles, 3))
largest = particles.PointData["plastic_strain"].GetRange(0)[1]
anvil.color_by(spheres, view, "plastic_strain", None, anvil.STRAIN, 0.0, anvil.rounded_up(largest), "plastic strain")
anvil.show_time(particles, view)
aim(view)
show_wall(particles, view)
anvil.show_history(path, view, anvil.ENERGIES, "energy")
anvil.finish(view, ARGUMENTS)
