"""Pictures of results; functions take a dataset and matplotlib axes."""

from moorage.plot.along import plot_along
from moorage.plot.animation import animate
from moorage.plot.figure import result_figure, save_figure
from moorage.plot.moorings import moorings
from moorage.plot.profile import plot_plan, plot_profile
from moorage.plot.seabed import seabed_map
from moorage.plot.tension import plot_tension
from moorage.plot.waves import plot_elevation

__all__ = [
    "animate",
    "moorings",
    "plot_along",
    "plot_elevation",
    "plot_plan",
    "plot_profile",
    "plot_tension",
    "result_figure",
    "save_figure",
    "seabed_map",
]
