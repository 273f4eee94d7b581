"""Files into models and back."""

from moorage.io.convert import convert
from moorage.io.moordyn import (
    DriverCase,
    FarmCase,
    is_driver,
    is_farm,
    read_driver,
    read_farm,
    read_moordyn,
    write_moordyn,
)
from moorage.io.motion import motion_of_turbines, read_motion
from moorage.io.native import read_native, write_native
from moorage.io.property_maps import read_friction_map, read_stiffness_map
from moorage.io.raster import read_bathymetry
from moorage.io.read import read

__all__ = [
    "DriverCase",
    "FarmCase",
    "convert",
    "is_driver",
    "is_farm",
    "motion_of_turbines",
    "read",
    "read_bathymetry",
    "read_driver",
    "read_farm",
    "read_friction_map",
    "read_moordyn",
    "read_motion",
    "read_native",
    "read_stiffness_map",
    "write_moordyn",
    "write_native",
]
