"""MoorDyn's files: model (v2 of C and F, v1), driver, and the writer."""

from moorage.io.moordyn.driver import DriverCase, is_driver, read_driver
from moorage.io.moordyn.farm import FarmCase, is_farm, read_farm
from moorage.io.moordyn.reader import read_moordyn
from moorage.io.moordyn.writer import write_moordyn

__all__ = [
    "DriverCase",
    "FarmCase",
    "is_driver",
    "is_farm",
    "read_driver",
    "read_farm",
    "read_moordyn",
    "write_moordyn",
]
