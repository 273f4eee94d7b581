"""VTK files hold the numbers of the result: read back with an XML parser, and with VTK itself where it is installed."""

import base64
import dataclasses
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

import moorage
import moorage.moordyn as moordyn
from moorage.cli import app
from moorage.model import Bathymetry, Rod, RodType
from moorage.results.vtk_file import TYPES, polydata

EXAMPLE = Path(__file__).parents[2] / "examples" / "oc4" / "oc4.dat"


def read(path):
    """Return points, cells by kind, and point and cell data of a file."""
    root = ET.parse(path).getroot()
    assert (root.get("type"), root.get("header_type")) == ("PolyData", "UInt64")
    piece = root.find("PolyData/Piece")
    points = array(piece.find("Points/DataArray"))
    assert len(points) == int(piece.get("NumberOfPoints"))
    cells = {}
    for kind in ("Verts", "Lines", "Polys"):
        numbers, ends = (array(element) for element in piece.find(kind))
        assert len(ends) == int(piece.get(f"NumberOf{kind}"))
        cells[kind] = np.split(numbers, ends[:-1]) if len(ends) else []
    data = {e.get("Name"): array(e) for tag in ("PointData", "CellData") for e in piece.find(tag)}
    return points, cells, data


def array(element):
    payload = base64.b64decode(element.text)
    size = int(np.frombuffer(payload[:8], "<u8")[0])
    assert size == len(payload) - 8
    kind = {v: k for k, v in TYPES.items()}[element.get("type")]
    values = np.frombuffer(payload[8:], "<" + kind)
    width = int(element.get("NumberOfComponents"))
    return values.reshape(-1, width) if width > 1 else values


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    model = moorage.read(EXAMPLE)
    motion = moorage.Motion.from_harmonics(2.0, ramp=1.0, surge=(1.0, 10.0))
    path = tmp_path_factory.mktemp("vtk") / "oc4.nc"
    return path, moorage.simulate(model, motion=motion, duration=2.0, dt_out=0.25, dt_nodes=0.5, output=path)


def test_a_series_holds_the_result(result, tmp_path):
    path, ds = result
    outcome = CliRunner().invoke(app, ["vtk", str(path), "-o", str(tmp_path), "--every", "2"])
    assert outcome.exit_code == 0, outcome.output
    sets = list(ET.parse(tmp_path / "mooring.pvd").getroot().iter("DataSet"))
    assert sorted({float(s.get("timestep")) for s in sets}) == [0.0, 1.0, 2.0]
    assert all((tmp_path / s.get("file")).is_file() for s in sets)
    last = {s.get("group"): tmp_path / s.get("file") for s in sets if float(s.get("timestep")) == 2.0}
    assert set(last) == {"seabed", "lines", "points"}
    points, cells, data = read(last["lines"])
    now = ds.isel(node_time=-1)
    np.testing.assert_array_equal(points, now["node_position"].values)
    assert [len(c) for c in cells["Lines"]] == [(ds["node_line"] == k).sum() for k in (1, 2, 3)]
    T = now["segment_tension"].values[ds["segment_line"].values == 2]
    second = cells["Lines"][1]
    np.testing.assert_allclose(data["tension [N]"][second], [T[0], *(0.5 * (T[1:] + T[:-1])), T[-1]])
    np.testing.assert_array_equal(data["node_velocity [m s-1]"], now["node_velocity"].values)
    places, dots, forces = read(last["points"])
    np.testing.assert_array_equal(places, ds["point_position"].isel(time=-1).values)
    np.testing.assert_array_equal(forces["force [N]"], ds["point_force"].isel(time=-1).values)
    assert len(dots["Verts"]) == 6
    bed, faces, _ = read(last["seabed"])
    assert len(faces["Polys"]) == 1
    np.testing.assert_allclose(bed[:, 2], points[:, 2].min(), atol=0.1)
    assert bed[:, 0].min() < points[:, 0].min()


def test_statics_and_rods_and_grids(tmp_path):
    model = moorage.read(EXAMPLE)
    grid = Bathymetry(x=(-1000.0, 0.0, 1000.0), y=(-1000.0, 1000.0), depth=((200.0, 210.0),) * 3)
    environment = dataclasses.replace(model.environment, bathymetry=grid)
    rods = (Rod(id=7, rod_type="tube", kind="fixed", end_a=(0.0, 0.0, -10.0), end_b=(0.0, 0.0, 5.0), segments=3),)
    model = dataclasses.replace(
        model,
        environment=environment,
        rods=rods,
        rod_types=(RodType(name="tube", diameter=1.0, mass_per_length=0.0),),
        points=tuple(dataclasses.replace(p, position=(*p.position[:2], -200.0)) if p.kind == "fixed" else p for p in model.points),
    )  # fmt: skip
    with pytest.warns(moorage.ModelWarning):
        ds = moorage.solve_statics(model)
    ends = np.array([[[0.0, 0.0, -10.0], [0.0, 0.0, 5.0]]])
    ds["rod_position"] = (("rod", "rod_end", "xyz"), ends)
    ds = ds.assign_coords(rod=[7])
    series = moorage.write_vtk(ds, tmp_path / "new" / "folder")
    points, cells, data = read(series.parent / "rods_000000.vtp")
    np.testing.assert_array_equal(points, ends[0])
    assert [c.tolist() for c in cells["Lines"]] == [[0, 1]]
    assert data["rod"].tolist() == [7]
    bed, faces, depth = read(series.parent / "seabed.vtp")
    assert len(faces["Polys"]) == 2
    np.testing.assert_array_equal(np.sort(np.unique(bed[:, 2])), [-210.0, -200.0])
    np.testing.assert_array_equal(depth["depth [m]"], -bed[:, 2])


def test_a_result_without_nodes_is_refused(result, tmp_path):
    with pytest.raises(moorage.ResultError, match="no node histories"):
        moorage.write_vtk(result[1].drop_vars("node_position"), tmp_path)


def test_the_present_state_of_moordyns_module(deck, tmp_path):
    system = moordyn.Create(str(deck()))
    point, line = moordyn.GetPoint(system, 2), moordyn.GetLine(system, 1)
    moordyn.Init(system, moordyn.GetPointPos(point), [0.0] * 3)
    assert moordyn.SaveVTK(system, str(tmp_path / "out" / "now.vtm")) == 0
    files = [e.get("file") for e in ET.parse(tmp_path / "out" / "now.vtm").getroot().iter("DataSet")]
    assert files == ["now/line1.vtp", "now/point1.vtp", "now/point2.vtp"]
    points, _, data = read(tmp_path / "out" / files[0])
    np.testing.assert_array_equal(points[3], moordyn.GetLineNodePos(line, 3))
    assert data["tension [N]"].max() == pytest.approx(moordyn.GetLineMaxTen(line))
    assert moordyn.SavePointVTK(point, str(tmp_path / "point.vtp")) == 0
    np.testing.assert_array_equal(read(tmp_path / "point.vtp")[2]["force [N]"], [moordyn.GetPointForce(point)])
    with pytest.raises(RuntimeError):
        moordyn.SaveLineVTK(line, str(tmp_path / "none" / "line.vtp"))


def test_vtk_reads_it(tmp_path):
    vtk = pytest.importorskip("vtk")
    path = tmp_path / "a.vtp"
    values = np.array([1.0, 2.0, 3.0])
    path.write_text(polydata(np.eye(3), {"Lines": [np.array([0, 1, 2])]}, {"tension": (values, "N")}))
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    out = reader.GetOutput()
    assert (out.GetNumberOfPoints(), out.GetNumberOfLines()) == (3, 1)
    assert [out.GetPointData().GetArray("tension [N]").GetValue(k) for k in range(3)] == [1.0, 2.0, 3.0]
    assert out.GetPoint(1) == (0.0, 1.0, 0.0)
