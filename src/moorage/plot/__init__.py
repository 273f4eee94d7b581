"""Pictures of results; functions take a dataset and matplotlib axes."""

from moorage.plot.along import plot_along
from moorage.plot.animation import animate
from moorage.plot.envelope import plot_envelope
from moorage.plot.figure import result_figure, save_figure
from moorage.plot.moorings import moorings
from moorage.plot.pictures import picture, save_picture
from moorage.plot.profile import plot_plan, plot_profile
from moorage.plot.seabed import seabed_map
from moorage.plot.spectrum import plot_spectrum
from moorage.plot.tension import plot_tension
from moorage.plot.waves import plot_elevation

__all__ = [
    "animate",
    "moorings",
    "picture",
    "plot_along",
    "plot_elevation",
    "plot_envelope",
    "plot_plan",
    "plot_profile",
    "plot_spectrum",
    "plot_tension",
    "result_figure",
    "save_figure",
    "save_picture",
    "seabed_map",
]
