"""The functions that write the present state as VTK files; MoorDyn-C needs a build with the VTK library for them."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from moorage.moordyn import codes
from moorage.moordyn.handles import Body, Line, Point, Rod, live, raising
from moorage.moordyn.lines import GetLineNodePos, GetLineNodeTen, GetLineNumberNodes
from moorage.moordyn.points import GetPointForce, GetPointPos
from moorage.moordyn.rods import GetRodNodePos, GetRodNumberNodes
from moorage.moordyn.system import System
from moorage.results.vtk_file import multiblock, polydata


@raising
def SaveVTK(instance: System, filename: str) -> int:
    """Write lines, points and rods: a group (.vtm) with a .vtp file of each in a folder beside it of the same name."""
    model, path = live(instance).model, Path(filename)
    folder = path.with_suffix("")
    files: dict[str, Path] = {}
    folder.mkdir(parents=True, exist_ok=True)
    texts = {f"line {line.id}": line_text(Line(instance, k)) for k, line in enumerate(model.lines)}
    texts |= {f"point {point.id}": point_text(Point(instance, k)) for k, point in enumerate(model.points)}
    texts |= {f"rod {rod.id}": rod_text(Rod(instance, k)) for k, rod in enumerate(model.rods)}
    for name, text in texts.items():
        files[name] = Path(folder.name) / f"{name.replace(' ', '')}.vtp"
        (path.parent / files[name]).write_text(text)
    path.write_text(multiblock(files))
    return codes.ERRCODE_SUCCESS


@raising
def SaveLineVTK(instance: Line, filename: str) -> int:
    """Write a line with the tension at its nodes (.vtp)."""
    Path(filename).write_text(line_text(instance))
    return codes.ERRCODE_SUCCESS


@raising
def SavePointVTK(instance: Point, filename: str) -> int:
    """Write a point with the force on it (.vtp)."""
    Path(filename).write_text(point_text(instance))
    return codes.ERRCODE_SUCCESS


@raising
def SaveRodVTK(instance: Rod, filename: str) -> int:
    """Write a rod (.vtp)."""
    Path(filename).write_text(rod_text(instance))
    return codes.ERRCODE_SUCCESS


def SaveBodyVTK(instance: Body, filename: str) -> int:
    """Refuse: a body has no shape."""
    live(instance.system)
    raise RuntimeError("SaveBodyVTK: bodies have no shape; the points and rods on them are in SaveVTK")


def UseBodyVTK(instance: Body, filename: str) -> int:
    """Refuse: bodies have no shape."""
    live(instance.system)
    raise RuntimeError("UseBodyVTK: bodies have no shape; open their model in ParaView beside the mooring")


def line_text(instance: Line) -> str:
    """Return a line as a file."""
    nodes = range(GetLineNumberNodes(instance))
    r, pull = (np.array([f(instance, i) for i in nodes]) for f in (GetLineNodePos, GetLineNodeTen))
    return polydata(r, {"Lines": [np.array(nodes)]}, {"tension": (np.linalg.norm(pull, axis=1), "N")})


def point_text(instance: Point) -> str:
    """Return a point as a file."""
    force = np.array([GetPointForce(instance)])
    return polydata(np.array([GetPointPos(instance)]), {"Verts": [np.array([0])]}, {"force": (force, "N")})


def rod_text(instance: Rod) -> str:
    """Return a rod as a file."""
    nodes = range(GetRodNumberNodes(instance))
    r = np.array([GetRodNodePos(instance, i) for i in nodes])
    return polydata(r, {"Lines": [np.array(nodes)]})
