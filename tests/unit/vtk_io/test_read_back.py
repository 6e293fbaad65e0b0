#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reads particle files with VTK's own Python module and compares every number with what Anvil was given.

Usage: test_read_back.py WRITE_MUSHROOM, the program that writes the files and their numbers as CSV.
"""

import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

FRAMES = 3
ACROSS = 4
PARTICLES = 5 * ACROSS**3
WRITER = None  # set from the command line

COMPONENTS = {
    "particle_id": [None],
    "body": [None],
    "initial_position": ["X", "Y", "Z"],
    "velocity": ["X", "Y", "Z"],
    "density": [None],
    "pressure": [None],
    "stress": ["XX", "YY", "ZZ", "XY", "YZ", "XZ"],
    "plastic_strain": [None],
    "smoothing_length": [None],
}
UNITS = [
    "particle_id: ", "body: ", "initial_position: m", "velocity: m/s", "density: kg/m3", "pressure: Pa", "stress: Pa",
    "plastic_strain: ", "smoothing_length: m",
]


def read(path):
    reader = vtkXMLPolyDataReader() if path.suffix == ".vtp" else vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def read_numbers(path):
    names = path.read_text().splitlines()[0].split(",")
    columns = numpy.loadtxt(path, delimiter=",", skiprows=1).T
    return dict(zip(names, columns))


class ReadBack(unittest.TestCase):
    def check_array(self, array, numbers, name, kind):
        values = vtk_to_numpy(array).reshape(PARTICLES, -1)
        self.assertEqual(values.dtype, kind, name)
        for component in range(values.shape[1]):
            # Rounding to the type of the file is all that may happen to a number.
            expected = numbers[f"{name}.{component}"].astype(kind)
            numpy.testing.assert_array_equal(values[:, component], expected, err_msg=name)

    def check_frame(self, particles, numbers, kind):
        self.assertEqual(particles.GetNumberOfPoints(), PARTICLES)
        self.assertEqual(particles.GetNumberOfCells(), PARTICLES)
        self.assertEqual(particles.GetCellType(PARTICLES - 1), 1)  # a vertex
        self.check_array(particles.GetPoints().GetData(), numbers, "Points", kind)
        arrays = particles.GetPointData()
        self.assertEqual([arrays.GetArrayName(i) for i in range(arrays.GetNumberOfArrays())], list(COMPONENTS))
        for name, components in COMPONENTS.items():
            array = arrays.GetArray(name)
            found = [array.GetComponentName(i) for i in range(array.GetNumberOfComponents())]
            self.assertEqual(found, components, name)
            self.check_array(array, numbers, name, numpy.int32 if name in ("particle_id", "body") else kind)

    def check_fields(self, fields, time, index):
        self.assertEqual(fields.GetArray("TimeValue").GetNumberOfTuples(), 1)
        self.assertEqual(fields.GetArray("TimeValue").GetDataTypeAsString(), "double")
        self.assertEqual(fields.GetArray("TimeValue").GetValue(0), time)
        self.assertEqual(fields.GetArray("frame_index").GetValue(0), index)
        units = fields.GetAbstractArray("units")
        self.assertEqual([units.GetValue(i) for i in range(units.GetNumberOfValues())], UNITS)
        self.assertEqual(fields.GetAbstractArray("scene").GetValue(0), "mushroom")
        self.assertIn("copper rod", fields.GetAbstractArray("title").GetValue(0))

    def check_series(self, folder, file_format, precision, compression):
        subprocess.run([WRITER, folder, str(ACROSS), str(FRAMES), file_format, precision, compression], check=True)
        entries = ElementTree.parse(folder / "mushroom.pvd").getroot().findall("Collection/DataSet")
        self.assertEqual(len(entries), FRAMES)
        for index, entry in enumerate(entries):
            self.assertEqual(entry.get("file"), f"frames/mushroom_{index:06d}.{file_format}")
            numbers = read_numbers(folder / f"{index}.csv")
            time = numbers["TimeValue"][0]
            self.assertEqual(float(entry.get("timestep")), time)
            particles = read(folder / entry.get("file"))
            self.check_frame(particles, numbers, numpy.float32 if precision == "float32" else numpy.float64)
            self.check_fields(particles.GetFieldData(), time, index)

    def test_every_format(self):
        for file_format in ("vtp", "vtu"):
            for precision in ("float32", "float64"):
                for compression in ("lz4", "zlib", "none"):
                    with self.subTest(file_format=file_format, precision=precision, compression=compression):
                        with tempfile.TemporaryDirectory() as folder:
                            self.check_series(Path(folder), file_format, precision, compression)


if __name__ == "__main__":
    WRITER = sys.argv.pop(1)
    unittest.main()
