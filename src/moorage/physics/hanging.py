"""Where a limp elastic line of any sections hangs between two points: the minimum of a convex function of two numbers.

With the horizontal tension H and the vertical component V of the force at end A, segment j of the line carries
(H, V_j), V_j = V + the weight of the nodes below it. The complementary energy

    Phi(H, V) = sum l_j (T_j + T_j^2 / 2 EA_j) - H span - V rise,   T_j = sqrt(H^2 + V_j^2)

is convex, whatever the weights, buoyant ones too, and its gradient is by how much end B is missed. Where the lower end
lies on the bed, the segments up to the first that is lifted lie there: V_j = 0.
"""

from __future__ import annotations

import numpy as np

ITERATIONS = 60
TOLERANCE = 1e-6  # of the length


def hanging(
    span: float, rise: float, length, stiffness, weight, grounded: bool
) -> tuple[np.ndarray, np.ndarray] | None:
    """Return distances along the chord's heading and heights (nodes,) from end A, m; None where none is found.

    Parameters
    ----------
    span, rise : float
        Horizontal and vertical distance of end B from end A, m.
    length, stiffness, weight : (segments,) array
        Unstretched length, m; EA, N; weight in water, N. Half a segment's weight hangs on each of its nodes.
    grounded : bool
        Whether the lower end lies on the bed.
    """
    if rise < 0.0:
        turned = hanging(span, -rise, length[::-1], stiffness[::-1], weight[::-1], grounded)
        return None if turned is None else (span - turned[0][::-1], turned[1][::-1] + rise)
    below = np.concatenate([[0.0], np.cumsum(0.5 * (weight[1:] + weight[:-1]))])
    size, total = float(np.abs(weight).sum()) + 1.0, float(length.sum())

    def look(force):
        H, V = force
        v = V + below
        if grounded:
            v[: int(np.argmax(v > 0.0)) if (v > 0.0).any() else len(v)] = 0.0
        T = np.hypot(H, v) + 1e-12 * size
        energy = np.sum(length * (T + 0.5 * T * T / stiffness)) - H * span - V * rise
        reach = length * (1.0 / T + 1.0 / stiffness)  # of a segment over its force
        miss = np.array([np.sum(reach * H) - span, np.sum(reach * v) - rise])
        turn, stretch = length / T**3, length / stiffness
        lifted = v != 0.0
        cross = -np.sum(turn * H * v)
        K = np.array([[np.sum(turn * v * v + stretch), cross], [cross, np.sum((turn * H * H + stretch) * lifted)]])
        return energy, miss, K, reach * H, reach * v

    chord = float(np.hypot(span, rise))
    taut = max(chord / total - 1.0, 0.0) * total / float(np.sum(length / stiffness))  # what stretches it that far
    force = np.array([max(0.1 * size * span / total, 1.0), 0.0 if grounded else -0.5 * below[-1]])
    force += taut / max(chord, 1e-300) * np.array([span, rise])
    now = look(force)
    for _ in range(ITERATIONS):
        energy, miss, K, x, z = now
        largest = np.abs(miss).max()
        if largest < TOLERANCE * total:
            return np.concatenate([[0.0], np.cumsum(x)]), np.concatenate([[0.0], np.cumsum(z)])
        step = -np.linalg.solve(K + 1e-3 * min(total, largest) / size * np.eye(2), miss)
        step *= min(1.0, 0.3 * (size + taut) / np.abs(step).max())
        step *= min(1.0, 0.8 * force[0] / max(-step[0], 1e-300))  # H stays positive
        share = 1.0
        while True:
            trial = look(force + share * step)
            if trial[0] <= energy + 1e-4 * share * (miss @ step) + 1e-12 * abs(energy) or share < 1e-6:
                break
            share *= 0.5
        force, now = force + share * step, trial
    return None
