"""Files into models and back."""

from moorage.io.convert import convert
from moorage.io.moordyn import DriverCase, is_driver, read_driver, read_moordyn, write_moordyn
from moorage.io.motion import read_motion
from moorage.io.native import read_native, write_native
from moorage.io.property_maps import read_friction_map, read_stiffness_map
from moorage.io.raster import read_bathymetry
from moorage.io.read import read

__all__ = [
    "DriverCase",
    "convert",
    "is_driver",
    "read",
    "read_bathymetry",
    "read_driver",
    "read_friction_map",
    "read_moordyn",
    "read_motion",
    "read_native",
    "read_stiffness_map",
    "write_moordyn",
    "write_native",
]
