# SPDX-License-Identifier: BSD-3-Clause
"""ParaView state: a deforming rod as spheres coloured by plastic strain, with the time.

In ParaView: File > Load State, choose this file; the result is the one in the environment variable ANVIL_RESULT, else
results/rod_square beside the folder of this file. On the command line:

    pvbatch rod.py RESULT [PICTURE.png]

RESULT is a result folder or its .pvd file.
"""

import math
import os
import sys
from pathlib import Path

from paraview.simple import *

INK = [0.1, 0.1, 0.1]
# ParaView's window defines neither __file__ nor arguments.
HERE = Path(globals().get("__file__", "paraview_states/rod.py")).resolve().parent
ARGUMENTS = [argument for argument in getattr(sys, "argv", [])[1:] if not argument.startswith("-")]
STANDARD_RESULT = HERE.parent / "results" / "rod_square"


def find_series():
    """Path of the .pvd to open: first argument, environment, standard place."""
    result = Path(ARGUMENTS[0] if ARGUMENTS else os.environ.get("ANVIL_RESULT", STANDARD_RESULT))
    found = [result] if result.suffix == ".pvd" else sorted(result.glob("*.pvd"))
    if len(found) != 1 or not found[0].is_file():
        raise RuntimeError(f"rod.py: expected a .pvd file, or a folder with one, at '{result}'")
    return found[0].resolve()


def spacing_of(particles):
    """Distance between neighbours before the deformation: the smoothing length tells it, within its usual ratios."""
    low, _ = particles.PointData["smoothing_length"].GetRange(0)
    return low


def show_particles(particles, view):
    display = Show(particles, view)
    display.SetRepresentationType("Point Gaussian")
    display.ShaderPreset = "Sphere"
    display.GaussianRadius = 0.55 * spacing_of(particles)
    ColorBy(display, ("POINTS", "plastic_strain"))
    display.SetScalarBarVisibility(view, True)
    return display


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


def color_plastic_strain(particles, view):
    """Light grey where nothing has yielded, over yellow to red and dark red at the largest strain: that of the last
    frame, rounded up, in every frame."""
    _, largest = particles.PointData["plastic_strain"].GetRange(0)
    high = max(0.5, math.ceil(2.0 * largest) / 2.0)
    colors = GetColorTransferFunction("plastic_strain")
    colors.ColorSpace = "Lab"
    colors.RGBPoints = [
        0.0, 0.87, 0.87, 0.87,
        0.30 * high, 0.98, 0.84, 0.36,
        0.65 * high, 0.87, 0.25, 0.12,
        high, 0.38, 0.02, 0.06,
    ]
    colors.AutomaticRescaleRangeMode = "Never"
    bar = GetScalarBar(colors, view)
    bar.Title = "plastic strain"
    bar.ComponentTitle = ""
    bar.TitleColor = bar.LabelColor = INK
    bar.TitleFontSize = bar.LabelFontSize = 20
    bar.AutomaticLabelFormat = 0
    bar.LabelFormat = "%.1f"
    bar.RangeLabelFormat = "%.1f"
    bar.WindowLocation = "Any Location"
    bar.Position = [0.87, 0.3]
    bar.ScalarBarLength = 0.4


def show_time(particles, view):
    annotation = AnnotateTimeFilter(Input=particles)
    annotation.Format = "t = {time:.2f} µs"
    annotation.Scale = 1e6
    display = Show(annotation, view)
    display.Color = INK
    display.FontSize = 20
    display.WindowLocation = "Upper Right Corner"


def aim(view):
    """Looks at the first frame, the tallest, with room around it for the foot of the last one."""
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesLabelColor = INK
    view.CameraParallelProjection = 1
    view.CameraPosition = [0.5, -1.0, 0.4]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    ResetCamera(view)
    view.CameraParallelScale *= 1.3


series = PVDReader(registrationName="rod", FileName=str(find_series()))
series.UpdatePipeline()
rod_view = GetActiveViewOrCreate("RenderView")
show_particles(series, rod_view)
show_time(series, rod_view)
scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.GoToFirst()
aim(rod_view)
scene.GoToLast()
color_plastic_strain(series, rod_view)
show_wall(series, rod_view)
Render(rod_view)

if len(ARGUMENTS) > 1:
    rod_view.ViewSize = [1600, 1200]
    SaveScreenshot(ARGUMENTS[1], rod_view)
