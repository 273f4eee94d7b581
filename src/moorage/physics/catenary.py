"""Elastic catenary, the first guess of a line's shape: hanging, partly on the seabed, taut, slack, vertical or buoyant.

With H and V the tension components at the upper end, w the weight in water per unstretched length and s the arc length
from the lower end (Jonkman 2007, equations 2-35 to 2-38; friction left out):

    hanging    x(s) = H/w [asinh((V - w(L - s))/H) - asinh((V - wL)/H)] + H s / EA
               z(s) = H/w [sqrt(1 + ((V - w(L - s))/H)^2) - sqrt(1 + ((V - wL)/H)^2)] + (s / EA)(V - wL + w s / 2)
    grounded   the part s <= L - V/w lies on the bed with tension H.
"""

from __future__ import annotations

import numpy as np


def catenary(span: float, rise: float, length: float, stiffness: float, weight: float, arc, grounded: bool):
    """Shape of an elastic line between two ends.

    Parameters
    ----------
    span, rise : float
        Horizontal and vertical distance from end A to end B, m.
    length, stiffness, weight : float
        Unstretched length (m), EA (N) and weight in water (N/m, negative for a buoyant line).
    arc : (n,) array
        Unstretched arc lengths from end A, m.
    grounded : bool
        Whether a bed at the level of the lower end holds the line up.

    Returns
    -------
    (x, z) : arrays (n,), or None
        Horizontal and vertical position from end A, m; None when there is no such catenary (a vertical line, one with
        no weight, or one so long that a part of it lies slack in a heap).
    """
    arc = np.asarray(arc, dtype=float)
    if rise < 0.0:
        turned = catenary(span, -rise, length, stiffness, weight, length - arc, grounded)
        return None if turned is None else (span - turned[0], turned[1] + rise)
    if weight < 0.0:  # a buoyant line is a heavy one upside down
        turned = catenary(span, -rise, length, stiffness, -weight, arc, False)
        return None if turned is None else (turned[0], -turned[1])
    if span <= 1e-6 * length or weight == 0.0:
        return None
    compliance = stiffness / weight
    if grounded and length >= span - compliance + np.sqrt(compliance**2 + 2.0 * rise * compliance):
        return None
    forces = _solve(span, rise, length, stiffness, weight, grounded)
    if forces is None:
        return None
    return _shape(forces[0], forces[1], length, stiffness, weight, arc, grounded)


def _shape(H, V, L, EA, w, s, grounded):
    lying = max(L - V / w, 0.0) if grounded else 0.0
    V0 = max(V - w * L, 0.0) if grounded else V - w * L
    up = np.maximum(s - lying, 0.0)
    Vs = V0 + w * up
    x = H / w * (np.arcsinh(Vs / H) - np.arcsinh(V0 / H)) + H * s / EA + np.minimum(s, lying)
    z = H / w * (np.hypot(1.0, Vs / H) - np.hypot(1.0, V0 / H)) + up / EA * (V0 + 0.5 * w * up)
    return x, z


def _solve(X, Z, L, EA, w, grounded, tolerance=1e-9):
    """Tension components (H, V) at the upper end: Newton in (log H, V), shortened until the error falls."""
    chord = np.hypot(X, Z)
    slackness = 0.2 if chord >= L else np.sqrt(3.0 * max((L**2 - Z**2) / X**2 - 1.0, 1e-6))
    H, V = max(abs(0.5 * w * X / slackness), 1e-3 * w * L), 0.5 * w * (Z / np.tanh(slackness) + L)
    if chord > L:  # taut: the elastic chord is the better guess
        pull = EA * (chord / L - 1.0)
        H, V = max(pull * X / chord, H), max(pull * Z / chord + 0.5 * w * L, V)

    def miss(log_h, v):
        x, z = _shape(np.exp(log_h), v, L, EA, w, np.array([L]), grounded)
        return np.array([x[0] - X, z[0] - Z])

    u = np.array([np.log(H), V])
    error = miss(*u)
    for _ in range(100):
        size = np.linalg.norm(error)
        if size < tolerance * L:
            return float(np.exp(u[0])), float(u[1])
        steps = np.array([1e-7, 1e-7 * max(abs(u[1]), w * L)])
        J = np.array(
            [(miss(*(u + d)) - miss(*(u - d))) / (2.0 * k) for d, k in zip(np.diag(steps), steps, strict=True)]
        ).T
        try:
            increment = -np.linalg.solve(J, error)
        except np.linalg.LinAlgError:
            return None
        increment *= min(1.0, 2.0 / max(abs(increment[0]), 1e-300))
        for _ in range(30):
            trial = miss(*(u + increment))
            if np.linalg.norm(trial) < size:
                break
            increment *= 0.5
        else:
            return None
        u, error = u + increment, trial
    return None
