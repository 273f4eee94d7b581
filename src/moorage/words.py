"""What surrounds a mooring, and where its turbines are, in words for people."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import hypot
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from moorage.model import Current, CurrentGrid, Environment, Friction, Turbine


def sea_words(attrs: Mapping[str, Any]) -> str:
    """Return what the waves were made from and what came out, from the attributes of a result."""
    if "wave_asked" not in attrs:
        return ""
    count, seed = int(attrs["wave_components"]), attrs["wave_seed"]
    if count == 1 or str(attrs["wave_asked"]).startswith(("stokes", "stream-function")):
        return str(attrs["wave_asked"])
    achieved = f"Hs {attrs['wave_significant_height']:.3g} m, Tp {attrs['wave_peak_period']:.3g} s"
    drawn = "" if seed == "none" else f" of seed {seed}"
    return f"{attrs['wave_asked']}; achieved {achieved} with {count} components{drawn}"


def current_words(current: Current | CurrentGrid) -> str:
    """Return the current at its highest and lowest level in words, or the size of its grid."""
    if hasattr(current, "shape"):  # a grid; the classes themselves would load NumPy
        fastest = max(hypot(*row) for row in current.velocity.reshape(-1, 3).tolist())  # type: ignore[union-attr]
        sizes = " by ".join(map(str, current.shape))
        return f"up to {fastest:.3g} m/s on a grid of {sizes} points in t, x, y and z".replace("  ", " ")
    speeds = [hypot(*velocity) for velocity in current.velocity]
    if not any(speeds):
        return ""
    if len(speeds) == 1:
        return f"{speeds[0]:.3g} m/s"
    return f"{speeds[-1]:.3g} m/s at z = {current.z[-1]:g} m, {speeds[0]:.3g} m/s at {current.z[0]:g} m"


def seabed_words(environment: Environment) -> str:
    """Return the depth grid, the soil and the friction in words."""
    grid, friction = environment.bathymetry, environment.friction
    parts = []
    if grid is not None:
        parts.append(f"depth grid {grid.file} of {len(grid.x)} by {len(grid.y)} points".replace("  ", " "))
        parts += [str(grid.resampling)] if grid.resampling else []
    if environment.soil is not None:
        parts.append(f"soil with a memory, s_u = {environment.soil}")
    if friction is not None:
        parts.append(f"friction {friction_words(friction)}")
    return "; ".join(parts)


def friction_words(friction: Friction) -> str:
    """Return the law of friction and its kinetic coefficients in words."""
    size = "by a map" if friction.map else f"{friction.axial:g} along and {friction.transverse:g} across the line"
    return f"{friction.model}, {'by two curves' if friction.model == 'soil-curves' else size}"


def turbine_words(turbines: Iterable[Turbine]) -> str:
    """Return where the turbines of a farm are, in words."""
    return "; ".join(
        f"{turbine.id} {turbine.name}".rstrip() + f" at ({', '.join(f'{x:g}' for x in turbine.position)})"
        for turbine in turbines
    )
