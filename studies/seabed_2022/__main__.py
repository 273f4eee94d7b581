"""Do the study: `python -m studies.seabed_2022 [--quick] [--no-peers] [--out FOLDER]`."""

from studies.parts import Effort, Part, arguments, write
from studies.seabed_2022.bathymetry import four_seabeds
from studies.seabed_2022.choices import open_values
from studies.seabed_2022.dragging import CIRCLE, FAILURE, part
from studies.seabed_2022.laws import side_by_side
from studies.seabed_2022.wind_waves import friction_in_wind_and_waves


def parts(effort: Effort) -> list[Part]:
    """Return all parts of the study."""
    others = (four_seabeds, friction_in_wind_and_waves, side_by_side, open_values)
    return [part(FAILURE, effort), part(CIRCLE, effort), *(other(effort) for other in others)]


def main() -> None:
    """Write the page."""
    effort, folder = arguments("seabed_2022")
    write("seabed_2022", parts(effort), folder)


if __name__ == "__main__":
    main()
