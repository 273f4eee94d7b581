"""Do the study: `python -m studies.bending_2020 [--quick] [--no-peers] [--out FOLDER]`."""

from studies.bending_2020.beside import peer
from studies.bending_2020.choices import open_values
from studies.bending_2020.decay import decay
from studies.bending_2020.deflection import deflections, large_loads
from studies.bending_2020.deflection import open_values as open_of_cantilever
from studies.bending_2020.snapshots import scenario
from studies.parts import Effort, Part, arguments, write


def parts(effort: Effort) -> list[Part]:
    """Return all parts of the study."""
    of_effort = (part(effort) for part in (decay, scenario, open_values, peer))
    return [deflections(), large_loads(), open_of_cantilever(), *of_effort]


def main() -> None:
    """Write the page."""
    effort, folder = arguments("bending_2020")
    write("bending_2020", parts(effort), folder)


if __name__ == "__main__":
    main()
