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

HERE = Path(globals().get("__file__", Path(os.environ.get("ANVIL_STATES", "paraview_states")) / "shell.py")).resolve().parent
sys.path.insert(0, str(HERE))
import anvil_paraview as anvil

ARGUMENTS = [argument for argument in getattr(sys, "argv", [])[1:] if not argument.startswith("-")]

path = anvil.find_series(ARGUMENTS, HERE.parent / "results" / "be_shell")
view = anvil.show_flat_bodies(path, [("velocity", "Magnitude", anvil.STRAIN, "speed (m/s)")])
anvil.finish(view, ARGUMENTS)
