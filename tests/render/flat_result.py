# SPDX-License-Identifier: BSD-3-Clause
"""Small made-up results in one and two dimensions, written as another program would: plain XML, no Anvil involved."""

import math

COMPONENTS = {"velocity": "XYZ", "initial_position": "XYZ", "stress": ["XX", "YY", "ZZ", "XY", "YZ", "XZ"]}


def data_array(name, kind, rows):
    parts = COMPONENTS.get(name, "")
    names = "".join(f' ComponentName{i}="{part}"' for i, part in enumerate(parts))
    numbers = " ".join(f"{value:.9g}" for row in rows for value in row)
    return f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{len(rows[0])}"{names} format="ascii">{numbers}</DataArray>'


def write_frame(path, positions, arrays):
    count = len(positions)
    cells = " ".join(map(str, range(count)))
    ends = " ".join(map(str, range(1, count + 1)))
    path.write_text(
        f'<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian"><PolyData>'
        f'<Piece NumberOfPoints="{count}" NumberOfVerts="{count}">'
        f'<Points>{data_array("Points", "Float32", positions)}</Points>'
        f'<Verts><DataArray type="Int64" Name="connectivity" format="ascii">{cells}</DataArray>'
        f'<DataArray type="Int64" Name="offsets" format="ascii">{ends}</DataArray></Verts><PointData>'
        + "".join(data_array(name, "Float32", rows) for name, rows in arrays.items())
        + "</PointData></Piece></PolyData></VTKFile>\n")


def ring(progress):
    """Two rings that shrink, 240 particles."""
    positions, velocities = [], []
    for layer in range(4):
        for i in range(60):
            angle = 2.0 * math.pi * i / 60
            radius = (0.04 + 0.004 * layer) * (1.0 - 0.4 * progress)
            positions.append([radius * math.cos(angle), radius * math.sin(angle), 0.0])
            speed = 300.0 * (1.0 - 0.8 * progress)
            velocities.append([-speed * math.cos(angle), -speed * math.sin(angle), 0.0])
    return positions, {"velocity": velocities, "smoothing_length": [[0.005]] * len(positions)}


def column(progress, field):
    """A column of water or soil that sinks and spreads, 450 particles."""
    positions, values = [], []
    for j in range(30):
        for i in range(15):
            wide = 1.0 + progress
            positions.append([0.02 * i * wide, 0.02 * j / wide, 0.0])
            values.append([9810.0 * 0.02 * (29 - j) if field == "pressure" else 0.5 * progress * (29 - j) / 29])
    return positions, {field: values, "velocity": [[1.0, -1.0, 0.0]] * len(positions),
                       "smoothing_length": [[0.02]] * len(positions)}


def plate(progress):
    """A pulse of 1 GPa that runs through 100 particles."""
    positions = [[0.001 * i, 0.0, 0.0] for i in range(100)]
    stress = [[-1e9 if 90 * progress <= i < 90 * progress + 10 else 0.0, 0.0, 0.0, 0.0, 0.0, 0.0] for i in range(100)]
    return positions, {"initial_position": positions, "stress": stress, "velocity": [[0.0, 0.0, 0.0]] * 100,
                       "smoothing_length": [[0.0012]] * 100}


KINDS = {"shell": (ring, 30e-6), "water": (lambda p: column(p, "pressure"), 1.5),
         "soil": (lambda p: column(p, "plastic_strain"), 1.5), "plate": (plate, 15e-6)}


def write_history(folder, end, unit="J"):
    rows = [f"time [s],step,kinetic_energy [{unit}],total_energy [{unit}]"]
    rows += [f"{end * i / 20:.9g},{i},{100.0 - 4.0 * i},{100.0}" for i in range(21)]
    (folder / "history.csv").write_text("\n".join(rows) + "\n")


def write_result(folder, kind, name, frames=4):
    """Writes `frames` frames, NAME.pvd and history.csv; returns the times and the number of particles."""
    make, end = KINDS[kind]
    (folder / "frames").mkdir(parents=True)
    times, count, entries = [], 0, []
    for i in range(frames):
        positions, arrays = make(i / (frames - 1))
        file = f"frames/{name}_{i:06d}.vtp"
        write_frame(folder / file, positions, arrays)
        times.append(end * i / (frames - 1))
        count = len(positions)
        entries.append(f'<DataSet timestep="{times[-1]!r}" file="{file}"/>')
    (folder / f"{name}.pvd").write_text(
        f'<VTKFile type="Collection" version="1.0"><Collection>{"".join(entries)}</Collection></VTKFile>\n')
    write_history(folder, end, "J/m2" if kind == "plate" else "J/m")
    return times, count
