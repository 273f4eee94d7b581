"""What the user describes: frozen dataclasses in SI units, without numerics."""

from moorage.model.components import (
    Attachment,
    BendStiffener,
    Body,
    BuoyancyModules,
    Control,
    Curve,
    ExternalLoad,
    Failure,
    Line,
    LineType,
    Point,
    Rod,
    RodType,
    Section,
)
from moorage.model.current_grid import CurrentGrid
from moorage.model.environment import (
    Bathymetry,
    Current,
    Environment,
    Friction,
    FrictionMap,
    Resampling,
    Soil,
    StiffnessMap,
    UnreadWater,
)
from moorage.model.model import Model, OutputChannel, UnusedOption
from moorage.model.motion import Motion
from moorage.model.turbines import Turbine
from moorage.model.waves import Waves

__all__ = [
    "Attachment",
    "Bathymetry",
    "BendStiffener",
    "Body",
    "BuoyancyModules",
    "Control",
    "Current",
    "CurrentGrid",
    "Curve",
    "Environment",
    "ExternalLoad",
    "Failure",
    "Friction",
    "FrictionMap",
    "Line",
    "LineType",
    "Model",
    "Motion",
    "OutputChannel",
    "Point",
    "Resampling",
    "Rod",
    "RodType",
    "Section",
    "Soil",
    "StiffnessMap",
    "Turbine",
    "UnreadWater",
    "UnusedOption",
    "Waves",
]
