"""The records of a static solution, and those of its tensions that a run keeps."""

from __future__ import annotations

import numpy as np

from moorage.layout import copy_of
from moorage.physics.motion import no_tracks, sample_track
from moorage.physics.sea import no_sea
from moorage.solve.blocks import Block
from moorage.solve.march import March, Settings
from moorage.system.build import Built, with_motion


def records_at_rest(built: Built, settings: Settings) -> Block:
    """Return the records of a solved state with nothing in motion: neither what a motion holds, nor the sea.

    The records at time 0 of a run hold drag, damping and inertia where its motion or its sea starts at once. The state
    is left as it is.
    """
    tracks = built.system.tracks
    now = np.zeros((len(tracks.rest), 1, 9))  # position, velocity and acceleration at time 0
    for k in range(len(now)):
        sample_track(tracks, k, np.zeros(1), now[k, :, 0:3], now[k, :, 3:6], now[k, :, 6:9])
    still = with_motion(built, no_tracks(now[:, 0, 0:3]))
    still = still._replace(system=still.system._replace(sea=no_sea()), state=copy_of(built.state))
    return March(still, settings, 0.0).first()


def static_tensions(built: Built) -> dict[str, np.ndarray]:
    """Return the forces of the lines on what holds their ends, (lines,) N, in a solved state."""
    force = records_at_rest(built, Settings())["end_force"][0]
    tension = np.sqrt((force**2).sum(axis=-1))
    return {"static_anchor_tension": tension[:, 0], "static_fairlead_tension": tension[:, 1]}
