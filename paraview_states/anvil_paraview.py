# SPDX-License-Identifier: BSD-3-Clause
"""What the states of this folder share: finding a result, particles as spheres, colours, time, history plot.

The states import it from their own folder. ParaView's window tells a script neither its place nor arguments; there it
is found when ParaView was started in the top folder of Anvil, or when ANVIL_STATES names this folder.
"""

import csv
import math
import os
from pathlib import Path

from paraview.simple import *

INK = [0.1, 0.1, 0.1]
# Light where nothing happens, so that shading shows the shape: places from 0 to 1 with red, green and blue.
STRAIN = [0.0, 0.87, 0.87, 0.87, 0.30, 0.98, 0.84, 0.36, 0.65, 0.87, 0.25, 0.12, 1.0, 0.38, 0.02, 0.06]
SIGNED = [-1.0, 0.05, 0.07, 0.35, -0.65, 0.13, 0.33, 0.75, -0.30, 0.50, 0.75, 0.93] + STRAIN
WATER = [0.0, 0.83, 0.91, 0.96, 0.35, 0.52, 0.75, 0.88, 0.7, 0.16, 0.47, 0.74, 1.0, 0.03, 0.17, 0.40]
EARTH = [0.0, 0.92, 0.87, 0.74, 0.35, 0.84, 0.66, 0.40, 0.7, 0.62, 0.33, 0.13, 1.0, 0.26, 0.11, 0.05]


def find_series(arguments, standard):
    """Path of the .pvd to open: first argument, else the environment variable ANVIL_RESULT, else `standard`. Each is a
    result folder or its .pvd."""
    result = Path(arguments[0] if arguments else os.environ.get("ANVIL_RESULT", standard))
    found = [result] if result.suffix == ".pvd" else sorted(result.glob("*.pvd"))
    if len(found) != 1 or not found[0].is_file():
        raise RuntimeError(f"expected a .pvd file, or a folder with one, at '{result}'; name it as argument or in the "
                           "environment variable ANVIL_RESULT")
    return found[0].resolve()


def open_series(path):
    """The particles as source "particles", at their last time, and the view to show them in."""
    particles = PVDReader(registrationName="particles", FileName=str(path))
    particles.UpdatePipeline()
    scene = GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.GoToLast()
    view = GetActiveViewOrCreate("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesLabelColor = INK
    view.CameraParallelProjection = 1
    return particles, view


def first_available(particles, names):
    """The first of the arrays that the result has."""
    there = [particles.PointData.GetArray(i).GetName() for i in range(particles.PointData.GetNumberOfArrays())]
    for name in names:
        if name in there:
            return name
    raise RuntimeError(f"the result has none of the arrays {', '.join(names)}; it has {', '.join(there)}")


def spacing_of(particles, dimension):
    """Distance between particles: from the space they take up, which holes make too large; at most the smoothing
    length."""
    content = particles.GetDataInformation()
    bounds = content.GetBounds()
    lengths = [bounds[2 * i + 1] - bounds[2 * i] for i in range(dimension)]
    spacing = (math.prod(lengths) / content.GetNumberOfPoints()) ** (1.0 / dimension)
    if particles.PointData.GetArray("smoothing_length") is None:
        return spacing
    return min(spacing, particles.PointData["smoothing_length"].GetRange(0)[0])


def show_spheres(particles, view, radius, shader="Sphere"):
    display = Show(particles, view)
    display.SetRepresentationType("Point Gaussian")
    display.ShaderPreset = shader
    display.GaussianRadius = radius
    return display


def rounded_up(value):
    """The next of 1, 2, 2.5, 5 times a power of ten."""
    if value <= 0.0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(value))
    return next(f * power for f in (1.0, 2.0, 2.5, 5.0, 10.0) if value <= 1.01 * f * power)


def color_by(display, view, array, component, stops, low, high, title):
    """Colours in the same range at all times. `component` is "Magnitude", "XX" and so on, or None for a scalar.
    `stops` from -1 or 0 to 1 are spread over low (or -high) to high."""
    ColorBy(display, ("POINTS", array, component) if component else ("POINTS", array))
    colors = GetColorTransferFunction(array)
    colors.ColorSpace = "Lab"
    points = []
    for i in range(0, len(stops), 4):
        place = stops[i] * high if stops[0] < 0.0 else low + stops[i] * (high - low)
        points += [place] + stops[i + 1:i + 4]
    colors.RGBPoints = points
    colors.AutomaticRescaleRangeMode = "Never"
    display.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(colors, view)
    bar.Title = title
    bar.ComponentTitle = ""
    bar.TitleColor = bar.LabelColor = INK
    bar.TitleFontSize = bar.LabelFontSize = 18
    bar.AutomaticLabelFormat = 0
    bar.LabelFormat = bar.RangeLabelFormat = "%.3g"
    bar.WindowLocation = "Any Location"
    bar.Position = [0.84, 0.3]
    bar.ScalarBarLength = 0.4


def show_time(particles, view, unit="µs", per_second=1e6):
    annotation = AnnotateTimeFilter(registrationName="time", Input=particles)
    annotation.Format = "t = {time:.2f} " + unit
    annotation.Scale = per_second
    display = Show(annotation, view)
    display.Color = INK
    display.FontSize = 18
    display.WindowLocation = "Upper Right Corner"


def show_text(text, view):
    source = Text(registrationName="title", Text=text)
    display = Show(source, view)
    display.Color = INK
    display.FontSize = 18
    display.WindowLocation = "Upper Left Corner"


def extent_over_time(particles, array, component=0):
    """Bounds of the particles and the range of an array (-1: of its magnitude) over up to a dozen times of a series."""
    times = list(particles.TimestepValues)
    chosen = times[:: max(1, len(times) // 10)] + times[-1:]
    bounds, low, high = [math.inf, -math.inf] * 3, math.inf, -math.inf
    for time in chosen:
        particles.UpdatePipeline(time)
        now = particles.GetDataInformation().GetBounds()
        bounds = [pick(a, b) for pick, a, b in zip([min, max] * 3, bounds, now)]
        least, greatest = particles.PointData[array].GetRange(component)
        low, high = min(low, least), max(high, greatest)
    return bounds, low, high


def look_at_plane(view, bounds):
    """From above onto x and y, with room for the colour bar to the right."""
    x, y = (bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2
    width, height = bounds[1] - bounds[0], bounds[3] - bounds[2]
    x += 0.12 * width
    view.CameraFocalPoint = [x, y, 0.0]
    view.CameraPosition = [x, y, 10.0 * max(width, height)]
    view.CameraViewUp = [0.0, 1.0, 0.0]
    view.CameraParallelScale = 0.6 * max(height, 1.25 * width)


def add_chart(beside, title, x_title, y_title, share=0.62, below=False):
    """A chart to the right of a view, or below it; the view keeps `share` of the room."""
    layout = GetLayout(beside)
    place = layout.GetViewLocation(beside)
    chart = CreateView("XYChartView")
    split = layout.SplitVertical if below else layout.SplitHorizontal
    AssignViewToLayout(view=chart, layout=layout, hint=split(place, share) + 1)
    chart.ChartTitle = title
    chart.BottomAxisTitle, chart.LeftAxisTitle = x_title, y_title
    chart.LegendLocation = "TopRight"
    chart.ChartTitleColor = chart.BottomAxisColor = chart.LeftAxisColor = INK
    return chart


PALETTE = [(0.0, 0.45, 0.70), (0.84, 0.37, 0.0), (0.0, 0.62, 0.45), (0.80, 0.47, 0.65), (0.90, 0.62, 0.0)]


def draw_series(display, x, names):
    """Lines of the columns `names` ({column: label}) over the column `x`."""
    display.UseIndexForXAxis = 0
    display.XArrayName = x
    display.SeriesVisibility = list(names)
    display.SeriesLabel = [text for pair in names.items() for text in pair]
    display.SeriesColor = [text for i, name in enumerate(names)
                           for text in (name, *map(str, PALETTE[i % len(PALETTE)]))]
    display.SeriesLineThickness = [text for name in names for text in (name, "3")]
    display.SeriesPlotCorner = [text for name in names for text in (name, "0")]


ENERGIES = {"kinetic_energy": "kinetic", "elastic_energy": "elastic", "internal_energy": "internal",
            "plastic_work": "plastic work", "total_energy": "total"}


def show_history(path, beside, names, quantity, share=0.62):
    """Columns of the history.csv beside the .pvd at `path` in a chart of their own, named without their unit, which the
    axis gives after the `quantity`; None when there is no history."""
    file = path.parent / "history.csv"
    if not file.is_file():
        return None
    history = CSVReader(registrationName="history", FileName=[str(file)])
    history.UpdatePipeline()
    with file.open(newline="") as lines:
        rows = list(csv.DictReader(lines))
    columns = {title.split(" [")[0]: title for title in rows[0]}
    shown = {columns[name]: label for name, label in names.items() if name in columns}
    unit = next(iter(shown)).split(" [")[-1].rstrip("]").replace("m2", "m²")
    chart = add_chart(beside, "History", "time (s)", f"{quantity} ({unit})", share)
    # Room for the legend above the curves.
    values = [float(row[name]) for row in rows for name in shown]
    chart.LeftAxisUseCustomRange = 1
    chart.LeftAxisRangeMinimum, chart.LeftAxisRangeMaximum = min(0.0, *values), 1.35 * max(values)
    draw_series(Show(history, chart, "XYChartRepresentation"), "time [s]", shown)
    return chart


def show_flat_bodies(path, choices, *time_unit):
    """Bodies in x and y as spheres, with the time and the energies: all of a state for two dimensions. `choices` are
    rows of array, component, colours and title; the first whose array the result has gives the colours."""
    particles, view = open_series(path)
    spheres = show_spheres(particles, view, 0.55 * spacing_of(particles, 2))
    array = first_available(particles, [row[0] for row in choices])
    component, colors, title = next(row[1:] for row in choices if row[0] == array)
    bounds, _, largest = extent_over_time(particles, array, -1 if component == "Magnitude" else 0)
    look_at_plane(view, bounds)
    color_by(spheres, view, array, component, colors, 0.0, rounded_up(largest), title)
    show_time(particles, view, *time_unit)
    show_history(path, view, ENERGIES, "energy")
    return view


def finish(view, arguments):
    """Draws, and writes all views into the picture that the second argument names."""
    if len(arguments) > 1:
        GetLayout(view).SetSize(1600, 900)
        SaveScreenshot(arguments[1], GetLayout(view))
    else:
        Render(view)
