# SPDX-License-Identifier: BSD-3-Clause
"""Makes a .pvsm from one of the Python states: what File > Load State opens without Python.

    scripts/pvbatch paraview_states/make_pvsm.py STATE.py RESULT STATE.pvsm

RESULT is a result the state can show. ParaView writes absolute paths into a state; here they become the bare names of
the .pvd and of history.csv, which ParaView asks for, or looks for in the folder given as data directory, when it loads
the state.
"""

import os
import runpy
import sys
import tempfile
from pathlib import Path

from paraview import servermanager
from paraview.simple import GetViews

state, result, target = Path(sys.argv[1]).resolve(), sys.argv[2], Path(sys.argv[3])
sys.argv = [str(state), result]
series = runpy.run_path(str(state))["path"]
for view in GetViews():
    if view.GetXMLName() == "XYChartView":
        view.LeftAxisUseCustomRange = 0  # the state will show other results

with tempfile.TemporaryDirectory() as scratch:
    written = Path(scratch) / "state.pvsm"
    servermanager.SaveState(str(written))
    text = written.read_text()
for file in (series, series.parent / "history.csv"):
    text = text.replace(str(file), file.name)
if str(series.parent) in text or "<ServerManagerState" not in text:
    raise SystemExit("make_pvsm.py: ParaView wrote a state that cannot be moved")
unfinished = target.with_name(target.name + ".part")
unfinished.write_text(text)
os.replace(unfinished, target)
