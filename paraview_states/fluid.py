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

HERE = Path(globals().get("__file__", Path(os.environ.get("ANVIL_STATES", "paraview_states")) / "fluid.py")).resolve().parent
sys.path.insert(0, str(HERE))
import anvil_paraview as anvil

ARGUMENTS = [argument for argument in getattr(sys, "argv", [])[1:] if not argument.startswith("-")]

path = anvil.find_series(ARGUMENTS, HERE.parent / "results" / "water_column")
view = anvil.show_flat_bodies(path, [("plastic_strain", None, anvil.EARTH, "plastic strain"),
                                     ("pressure", None, anvil.WATER, "pressure (Pa)")], "s", 1.0)
anvil.finish(view, ARGUMENTS)
