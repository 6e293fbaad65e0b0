# SPDX-License-Identifier: BSD-3-Clause
"""ParaView state: water or soil in two dimensions as spheres, water by pressure and soil by plastic strain.

In ParaView: start it in the top folder of Anvil (or set ANVIL_STATES to this folder), File > Load State, choose this
file; the result is the one in the environment variable ANVIL_RESULT, else results/water_column. On the command line:

    scripts/pvbatch paraview_states/fluid.py RESULT [PICTURE.png]

RESULT is a result folder or its .pvd file.
"""

import os
import sys
from pathlib import Path

from paraview.simple import *

HERE = Path(globals().get("__file__", Path(os.environ.get("ANVIL_STATES", "paraview_states")) / "fluid.py")).resolve().parent
sys.path.insert(0, str(HERE))
import anvil_paraview as anvil

ARGUMENTS = [argument for argument in getattr(sys, "argv", [])[1:] if not argument.startswith("-")]


path = anvil.find_series(ARGUMENTS, HERE.parent / "results" / "water_column")
particles, view = anvil.open_series(path)
spheres = anvil.show_spheres(particles, view, 0.55 * anvil.spacing_of(particles, 2))
field = anvil.first_available(particles, ["plastic_strain", "pressure"])
colors, title = (anvil.EARTH, "plastic strain") if field == "plastic_strain" else (anvil.WATER, "pressure (Pa)")
bounds, _, largest = anvil.extent_over_time(particles, field)
anvil.look_at_plane(view, bounds)
anvil.color_by(spheres, view, field, None, colors, 0.0, anvil.rounded_up(largest), title)
anvil.show_time(particles, view, "s", 1.0)
anvil.show_history(path, view, anvil.ENERGIES, "energy (J/m)")
anvil.finish(view, ARGUMENTS)
