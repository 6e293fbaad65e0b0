# SPDX-License-Identifier: BSD-3-Clause
"""Makes rod.pvsm from rod.py: a state that File > Load State opens without Python.

    scripts/pvbatch paraview_states/make_pvsm.py RESULT STATE.pvsm

RESULT is a result of the scene rod_square. ParaView writes absolute paths into a state; here they become the bare name of
the .pvd, which ParaView asks for, or looks for in the folder given as data directory, when it loads the state.
"""

import os
import runpy
import sys
import tempfile
from pathlib import Path

from paraview import servermanager

folder = Path(__file__).resolve().parent
result, target = sys.argv[1], Path(sys.argv[2])
sys.argv = ["rod.py", result]
state = runpy.run_path(str(folder / "rod.py"))

with tempfile.TemporaryDirectory() as scratch:
    written = Path(scratch) / "state.pvsm"
    servermanager.SaveState(str(written))
    text = written.read_text()
series = state["find_series"]()
text = text.replace(str(series), series.name)
if str(series.parent) in text or "<ServerManagerState" not in text:
    raise SystemExit("make_pvsm.py: ParaView wrote a state that cannot be moved")
unfinished = target.with_name(target.name + ".part")
unfinished.write_text(text)
os.replace(unfinished, target)
