"""Farms in another program: six numbers a turbine, and the loads of all that it carries."""

import numpy as np
import pytest
from farms import SPAN, carrying, shared, swaying, without_turbines
from scipy.interpolate import CubicSpline

import moorage
import moorage.moordyn as moordyn
from moorage import Motion
from moorage.io import write_native
from moorage.model.motion import rotation_matrices


def rates(motion, times):
    """Displacements and their rates (n, 6) of a platform's motion at times."""
    spline = CubicSpline(motion.time, motion.platform)
    return spline(times), spline(times, 1)


def test_degrees_of_freedom_are_those_of_turbines():
    sim = moorage.Simulation(shared())
    assert sim.degrees_of_freedom == (("turbine", 1, 6), ("turbine", 2, 6))
    assert sim.points.tolist() == []
    np.testing.assert_array_equal(sim.position, [0, 0, 0, 0, 0, 0, SPAN, 0, 0, 0, 0, 0])
    forces = sim.initialize().reshape(2, 6)
    eq = moorage.solve_statics(sim.model)
    np.testing.assert_allclose(forces[:, :3], eq["turbine_force"].values, rtol=1e-6, atol=1.0)
    np.testing.assert_allclose(forces[:, 3:], eq["turbine_moment"].values, rtol=1e-6, atol=10.0)
    with pytest.raises(moorage.SimulationError, match=r"expected 12 finite numbers \(6 of turbine 1, 6 of turbine 2\)"):
        sim.step(0.1, np.zeros(6), np.zeros(6))


def test_stepping_is_a_run_with_the_same_motion():
    """Steps of 0.05 s; with errors of 0.1 mm a step both are within 1e-3 of the largest force (8e-3 with 2.6 mm)."""
    motions = {1: swaying(), 2: swaying(mirrored=True)}
    sim = moorage.Simulation(shared(), tolerance=1e-4)
    sim.initialize()
    home, times, loads = sim.position, 0.05 * np.arange(1, 101), []
    for time in times:
        parts = [rates(motion, time) for motion in motions.values()]
        loads.append(
            sim.step(time, home + np.concatenate([x for x, _ in parts]), np.concatenate([v for _, v in parts]))
        )
    loads = np.array(loads).reshape(len(times), 2, 6)
    ds = moorage.simulate(shared(), motion=Motion.from_turbines(motions), duration=5.0, dt_out=0.05, tolerance=1e-4)
    for name, part in (("turbine_force", loads[..., :3]), ("turbine_moment", loads[..., 3:])):
        expected = ds[name].values[1:]
        assert np.abs(part - expected).max() < 1e-3 * np.abs(expected).max()


def test_a_turbine_bears_the_loads_of_its_point_rod_and_body():
    """As three objects that a host moves by itself, in the same way: the sum of their loads, about the turbine."""
    at = (30.0, -40.0, 0.0)
    farm, plain = moorage.Simulation(carrying(at)), moorage.Simulation(without_turbines(carrying(at), at))
    assert [kind for kind, _, _ in plain.degrees_of_freedom] == ["body", "rod", "point"]
    farm.initialize()
    plain.initialize()
    home, start = farm.position, plain.position
    R0 = [rotation_matrices(start[None, k : k + 3])[0] for k in (3, 9)]
    for step in range(1, 6):
        time, (x, v) = 0.1 * step, rates(swaying(), 0.1 * step)
        loads = farm.step(time, home + x, v)
        ahead, behind = (_moved(start, R0, at, rates(swaying(), t)[0]) for t in (time + 1e-4, time - 1e-4))
        pose = _moved(start, R0, at, x)
        single = plain.step(time, pose, (ahead - behind) / 2e-4)
        origin, total = home[:3] + x[:3], np.zeros(6)
        for first, width in ((0, 6), (6, 6), (12, 3)):
            force = single[first : first + 3]
            total[:3] += force
            total[3:] += np.cross(pose[first : first + 3] - origin, force)
            total[3:] += single[first + 3 : first + 6] if width == 6 else 0.0
        np.testing.assert_allclose(loads, total, rtol=0, atol=2e-4 * np.abs(total).max())


def _moved(start, R0, at, x):
    """Pose of body, rod and point of a platform at `at` that is displaced by x (6,)."""
    R, out = rotation_matrices(x[None, 3:])[0], start.copy()
    for first in (0, 6, 12):
        out[first : first + 3] = at + x[:3] + R @ (start[first : first + 3] - at)
    for first, own in zip((3, 9), R0, strict=True):
        T = R @ own
        out[first : first + 3] = np.arctan2(-T[1, 2], T[2, 2]), np.arcsin(T[0, 2]), np.arctan2(-T[0, 1], T[0, 0])
    return out


def test_the_module_of_moordyn_moves_turbines(tmp_path):
    """MoorDyn-C knows none; here a native file with turbines has six numbers for each."""
    path = tmp_path / "farm.yaml"
    write_native(shared(), path)
    system = moordyn.Create(str(path))
    try:
        assert moordyn.NCoupledDOF(system) == 12
        x = [0.0] * 6 + [SPAN] + [0.0] * 5
        assert moordyn.Init(system, x, [0.0] * 12) == 0
        forces = np.array(moordyn.Step(system, x, [0.0] * 12, 0.0, 0.1))
    finally:
        moordyn.Close(system)
    expected = moorage.solve_statics(shared())["turbine_force"].values
    np.testing.assert_allclose(forces.reshape(2, 6)[:, :3], expected, rtol=1e-3, atol=1e2)
