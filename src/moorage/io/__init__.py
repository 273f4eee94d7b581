"""Files into models and back."""

from moorage.io.moordyn import DriverCase, is_driver, read_driver, read_moordyn
from moorage.io.motion import read_motion
from moorage.io.read import read

__all__ = ["DriverCase", "is_driver", "read", "read_driver", "read_moordyn", "read_motion"]
