# SPDX-License-Identifier: BSD-3-Clause
"""ParaView state: rings or other bodies in two dimensions as spheres coloured by speed, with the energies.

In ParaView: start it in the top folder of Anvil (or set ANVIL_STATES to this folder), File > Load State, choose this
file; the result is the one in the environment variable ANVIL_RESULT, else results/be_shell. On the command line:

    scripts/pvbatch paraview_states/shell.py RESULT [PICTURE.png]

RESULT is a result folder or its .pvd file.
"""

import os
import sys
from pathlib import Path

from paraview.simple import *

HERE = Path(globals().get("__file__", Path(os.environ.get("ANVIL_STATES", "paraview_states")) / "shell.py")).resolve().parent
sys.path.insert(0, str(HERE))
import anvil_paraview as anvil

ARGUMENTS = [argument for argument in getattr(sys, "argv", [])[1:] if not argument.startswith("-")]


path = anvil.find_series(ARGUMENTS, HERE.parent / "results" / "be_shell")
particles, view = anvil.open_series(path)
spheres = anvil.show_spheres(particles, view, 0.55 * anvil.spacing_of(particles, 2))
bounds, _, fastest = anvil.extent_over_time(particles, "velocity", -1)
anvil.look_at_plane(view, bounds)
anvil.color_by(spheres, view, "velocity", "Magnitude", anvil.STRAIN, 0.0, anvil.rounded_up(fastest),
               "speed (m/s)")
anvil.show_time(particles, view)
anvil.show_history(path, view, anvil.ENERGIES, "energy (J/m)")
anvil.finish(view, ARGUMENTS)
