# SPDX-License-Identifier: BSD-3-Clause
"""Runs under pvbatch: opens a series or a state and reports as JSON what ParaView read and drew.

    pvbatch inspect_with_paraview.py REPORT series SERIES.pvd
    pvbatch inspect_with_paraview.py REPORT python_state STATE.py RESULT
    pvbatch inspect_with_paraview.py REPORT state_file STATE.pvsm RESULT
"""

import json
import runpy
import sys
import tempfile
from pathlib import Path

from paraview.simple import *
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader


def describe_series(series):
    report = {"times": list(series.TimestepValues), "points": [], "cells": []}
    for time in report["times"]:
        series.UpdatePipeline(time)
        content = series.GetDataInformation()
        report["points"].append(content.GetNumberOfPoints())
        report["cells"].append(content.GetNumberOfCells())
    arrays = {series.PointData.GetArray(i).GetName(): series.PointData.GetArray(i)
              for i in range(series.PointData.GetNumberOfArrays())}
    report["arrays"] = {name: array.GetNumberOfComponents() for name, array in arrays.items()}
    if "stress" in arrays:
        report["stress_components"] = [arrays["stress"].GetComponentName(i) for i in range(6)]
    return report


def describe_picture(view):
    with tempfile.TemporaryDirectory() as scratch:
        picture = str(Path(scratch) / "view.png")
        view.ViewSize = [800, 600]
        SaveScreenshot(picture, view)
        reader = vtkPNGReader()
        reader.SetFileName(picture)
        reader.Update()
        image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3].astype(int)
    drawn = (abs(pixels - 255) > 8).any(axis=2)
    colored = pixels.max(axis=2) - pixels.min(axis=2) > 60
    if not drawn.any():
        return {"drawn_share": 0.0, "colored_share": 0.0, "drawn_box": [0, 0, 0, 0]}
    rows, columns = drawn.any(axis=1).nonzero()[0], drawn.any(axis=0).nonzero()[0]
    box = [columns[0] / width, rows[0] / height, columns[-1] / width, rows[-1] / height]
    return {"drawn_share": float(drawn.mean()), "colored_share": float(colored.mean()),
            "drawn_box": [float(b) for b in box]}


def describe_charts():
    """What the chart views show: their titles, and how much of each picture is in colour (curves are)."""
    charts = []
    for view in GetViews():
        if view.GetXMLName() == "XYChartView":
            charts.append({"title": view.ChartTitle, "left_axis": view.LeftAxisTitle, **describe_picture(view)})
    return charts


def time_text():
    annotation = FindSource("time")
    return "" if annotation is None else annotation.Format


def main():
    report_path, kind, *paths = sys.argv[1:]
    if kind == "series":
        report = describe_series(PVDReader(FileName=paths[0]))
    else:
        if kind == "python_state":
            sys.argv = paths
            runpy.run_path(paths[0])
        else:
            LoadState(paths[0], data_directory=paths[1])
            GetAnimationScene().GoToLast()
        view = next(v for v in GetViews() if v.GetXMLName() == "RenderView")
        report = describe_picture(view)
        report["charts"] = describe_charts()
        report["time_text"] = time_text()
        report.update(describe_series(FindSource("particles")))
    Path(report_path).write_text(json.dumps(report))


main()
