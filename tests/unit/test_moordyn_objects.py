"""Rods and bodies of all kinds behind the two doors for hosts: `moorage.moordyn` and `moorage.Simulation`.

What a coupled object does to its host is weighed against rigid-body mechanics: weight, and mass times acceleration.
"""

import numpy as np
import pytest
from floats import AIR, VACUUM, body, floating, rod

import moorage
import moorage.moordyn as moordyn
from moorage.model import Attachment, Line, LineType, Point, RodType, Section
from moorage.model.motion import rotation_matrices

DECK = """MoorDyn input of bodies and rods
---------------------- ROD TYPES ------------------------------------
TypeName      Diam     Mass/m    Cd     Ca      CdEnd    CaEnd
(name)        (m)      (kg/m)    (-)    (-)     (-)      (-)
buoy          1        1.0e3     0.5    1.0     0.6      0.7
---------------------- LINE TYPES ------------------------------------
Name   Diam   MassDen  EA         BA    EI   Cd   Ca   CdAx  CaAx
(-)    (-)    (-)      (-)        (-)   (-)  (-)  (-)  (-)   (-)
nylon  0.124  35.0     5515288.0  -0.8  0.0  1.6  1.0  0.05  0.0
---------------------------- BODIES -----------------------------------------------------
ID  Attachment  X0  Y0  Z0   r0    p0  y0  Mass  CG*     I*   Volume  CdA*  Ca
(#) (-)         (m) (m) (m)  (deg) (deg) (deg) (kg) (m) (kg-m^2) (m^3) (m^2) (-)
1   free        1   10  -20  10.0  20  30  100   0|0|-1  100  0.5     2     1
---------------------- RODS ----------------------------------------
ID  RodType  Attachment  Xa  Ya   Za   Xb  Yb     Zb   NumSegs  RodOutputs
(#) (name)   (#/key)     (m) (m)  (m)  (m) (m)    (m)  (-)      (-)
1   buoy     free        3   -10  -22  4   -10.0  -20  4        p
2   buoy     pinned      13  -10  -22  14  -10.0  -20  4        p
----------------------- POINTS ----------------------------------------------
ID  Type   X    Y    Z    M     V  CdA  CA
(-) (-)    (m)  (m)  (m)  (kg)  (m^3)  (m^2)  (-)
1   Free   0.0  -10  -2   20.0  0  0    0
2   Fixed  0.0  -10  -12  0     0  0    0
3   Body1  0    0    1    5     0  0    0
-------------------------- LINES -------------------------------------------------
ID  LineType  NodeA  NodeB  UnstrLen  NumSegs  Outputs
(-) (-)       (-)    (-)    (m)       (-)      (-)
1   nylon     2      1      9         3        -
2   nylon     2      3      25        3        -
-------------------------- SOLVER OPTIONS---------------------------------------------------
70   WtrDpth
0.0  TmaxIC
1    disableOutput
--------------------------- need this line -------------------------------------------------
"""


@pytest.fixture
def path(tmp_path):
    file = tmp_path / "objects.txt"
    file.write_text(DECK)
    return file


def run(system, steps=10, dt=0.05):
    for _ in range(steps):
        moordyn.Step(system, [], [], system.time, dt)
    return np.concatenate([
        *moordyn.GetBodyState(moordyn.GetBody(system, 1)),
        *(moordyn.GetRodNodePos(moordyn.GetRod(system, k), 4) for k in (1, 2)),
        moordyn.GetLineNodePos(moordyn.GetLine(system, 2), 1),
    ])  # fmt: skip


@pytest.fixture
def system(path):
    made = moordyn.Create(str(path))
    assert moordyn.Init(made, [], []) == 0
    return made


def test_states_in_moordyns_format_hold_bodies_and_rods(system, path, tmp_path):
    """The same place at once (rounding), and the same way on, within what the averaged acceleration begins without."""
    there, file = run(system), tmp_path / "objects.ic"
    moordyn.SaveState(system, str(file))
    other = moordyn.Create(str(path))
    moordyn.Init_NoIC(other, [], [])
    moordyn.LoadState(other, str(file))
    np.testing.assert_allclose(run(other, 0), there, atol=1e-12)
    np.testing.assert_allclose(run(other), run(system), atol=1e-4)
    file.write_bytes(file.read_bytes().replace(np.array(there[0]).astype("<f8").tobytes(), b"\xff" * 8))
    with pytest.raises(RuntimeError, match="not finite"):
        moordyn.LoadState(other, str(file))


def test_saved_states_come_back_bit_for_bit(system):
    run(system)
    state = moordyn.Serialize(system)
    there = run(system)
    moordyn.Deserialize(system, state)
    np.testing.assert_array_equal(run(system), there)


def test_a_line_that_breaks_off_a_body_leaves_all_else_where_it_is(system):
    """Every row behind the new point moves up by one; the objects' frames do not."""
    before = run(system)
    moordyn.BreakLine(system, moordyn.GetPoint(system, 3), moordyn.GetLine(system, 2))
    assert moordyn.GetNumberPoints(system) == 4
    np.testing.assert_allclose(run(system, 0), before, atol=1e-12)
    end = moordyn.GetLineNodePos(moordyn.GetLine(system, 2), 3)
    np.testing.assert_allclose(moordyn.GetPointPos(moordyn.GetPoint(system, 4)), end, atol=1e-12)
    np.testing.assert_allclose(moordyn.GetPointPos(moordyn.GetPoint(system, 3)), end, atol=1e-12)
    after = run(system)
    assert after[2] > before[2]  # the body goes on, with its point
    arm = rotation_matrices(after[None, 3:6])[0] @ [0.0, 0.0, 1.0]
    np.testing.assert_allclose(moordyn.GetPointPos(moordyn.GetPoint(system, 3)), after[:3] + arm, atol=1e-9)


def test_a_line_that_fails_at_a_rod(path):
    """It comes off the end of the rod at its time, and holds on to a point of its own there."""
    text = DECK.replace("2   nylon     2      3  ", "2   nylon     2      R1B").replace(
        "---- SOLVER",
        "---- FAILURE ----\nID Point Lines FailTime FailTen\n(-) (-) (-) (s) (N)\n1 R1B 2 0.2 0\n---- SOLVER",
    )
    path.write_text(text)
    system = moordyn.Create(str(path))
    assert moordyn.Init(system, [], []) == 0
    run(system, 3)
    assert moordyn.GetNumberPoints(system) == 3
    run(system, 1)
    assert moordyn.GetNumberPoints(system) == 4
    end = moordyn.GetRodNodePos(moordyn.GetRod(system, 1), 4)
    np.testing.assert_allclose(moordyn.GetPointPos(moordyn.GetPoint(system, 4)), end, atol=1e-12)
    run(system, 4)
    assert np.linalg.norm(np.subtract(moordyn.GetPointPos(moordyn.GetPoint(system, 4)), end)) > 0.01


def test_mass_matrices(system):
    """A body's own, its added mass and the point on it; a rod's about its end A, mass by mass of its nodes."""
    run(system)
    body = moordyn.GetBody(system, 1)
    M = np.array(moordyn.GetBodyM(body))
    np.testing.assert_allclose(M, M.T, atol=1e-9 * M.max())
    line = np.array(moordyn.GetLineNodeM(moordyn.GetLine(system, 2), 3))  # of its end on the body
    np.testing.assert_allclose(M[:3, :3] - line, (100.0 + 0.5 * 1025.0 + 5.0) * np.eye(3), atol=1e-6)
    rod = moordyn.GetRod(system, 1)
    R = np.array(moordyn.GetRodM(rod))
    np.testing.assert_allclose(R, R.T, atol=1e-9 * R.max())
    along = np.subtract(moordyn.GetRodNodePos(rod, 4), moordyn.GetRodNodePos(rod, 0))
    length, area = np.linalg.norm(along), np.pi / 4.0
    axis = along / length
    end = 2.0 * 0.7 * 1025.0 * np.pi / 12.0
    assert axis @ R[:3, :3] @ axis == pytest.approx(1e3 * length + end, rel=1e-9)
    across = np.array([0.0, 1.0, 0.0])
    assert across @ R[:3, :3] @ across == pytest.approx((1e3 + 1025.0 * area) * length, rel=1e-9)
    # moment of inertia about end A across: (m + rho A) L^2 / 3 but for the added mass, which is at the nodes, and I / m
    dry = 1e3 * length * (length**2 / 3.0 + 1.0 / 16.0)
    wet = 1025.0 * area * length * length**2 * (1.0 / 3.0 + 1.0 / (6.0 * 4**2))
    assert across @ R[3:, 3:] @ across == pytest.approx(dry + wet, rel=1e-9)


HELD = {
    "body": ("body", 6, {"bodies": [body(kind="coupled", centre_of_gravity=(0.5, 0.0, -1.0))]}),
    "pinned body": ("body", 3, {"bodies": [body(kind="coupled-pinned", centre_of_gravity=(0.0, 0.0, -1.0))]}),
    "rod": ("rod", 6, {"rods": [rod(1, "coupled", (0, 0, -50), (0, 0, -48))]}),
    "pinned rod": ("rod", 3, {"rods": [rod(1, "coupled-pinned", (0, 0, -50), (0, 0, -52))]}),
}


@pytest.mark.parametrize("name", HELD)
def test_a_host_bears_the_weight_of_what_it_holds(name):
    """100 kg each, at rest in air; a coupled body hangs 1 m below its origin and 0.5 m off."""
    kind, width, things = HELD[name]
    sim = moorage.Simulation(floating(environment=AIR, **things))
    assert sim.degrees_of_freedom == ((kind, 1, width),)
    force = sim.initialize()
    wanted = np.zeros(width)
    wanted[2] = -100.0 * 9.80665
    if name == "body":
        wanted[4] = 0.5 * 100.0 * 9.80665
    np.testing.assert_allclose(force, wanted, atol=1e-4 * abs(wanted[2]))


def test_a_host_moves_the_mass_of_a_coupled_body():
    """Straight on at growing speed: -m a, and the moment of that about the origin.

    x = t^3 has constant jerk, so that each cubic step is it exactly and the force right to the last digits.
    """
    sim = moorage.Simulation(floating([body(kind="coupled", centre_of_gravity=(0.5, 0.0, -1.0))], environment=VACUUM))
    sim.initialize()
    for t in (0.1, 0.2, 0.3):
        force = sim.step(t, [t**3, 0.0, -50.0, 0.0, 0.0, 0.0], [3.0 * t**2, 0.0, 0.0, 0.0, 0.0, 0.0])
        m_a = 100.0 * 6.0 * t
        np.testing.assert_allclose(force, [-m_a, 0.0, 0.0, 0.0, m_a, 0.0], atol=1e-8 * 100.0)


@pytest.mark.parametrize("things", [
    {"bodies": [body(kind="coupled", centre_of_gravity=(2.0, 0.0, 0.0))]},
    {"bodies": [body(kind="coupled", mass=0.0, inertia=(0.0, 0.0, 0.0))],
     "points": [Point(id=1, kind="fixed", body=1, position=(2.0, 0.0, 0.0), mass=100.0)]},
    {"bodies": [body(kind="coupled", mass=0.0, inertia=(0.0, 0.0, 0.0))],
     "rods": [rod(1, "fixed", (2.0, 0.0, -1.0), (2.0, 0.0, 1.0), body=1)]},
], ids=["centre of gravity", "point", "rod"])  # fmt: skip
def test_a_host_feels_what_a_turning_body_pulls_outward(things):
    """A mass of 100 kg, 2 m from the axis, at 0.5 rad/s: m w^2 r outward, whatever it is that has the mass.

    Places follow cubics between the ends of steps, w h = 0.01 apart, whose second derivative is right to (w h)^2 / 12.
    """
    sim = moorage.Simulation(floating(environment=VACUUM, **things))
    spin, h = 0.5, 0.02
    sim.initialize(velocity=[0.0, 0.0, 0.0, 0.0, 0.0, spin])
    for k in range(1, 11):
        pose = np.array([0.0, 0.0, -50.0, 0.0, 0.0, spin * k * h])
        force = sim.step(k * h, pose, [0.0, 0.0, 0.0, 0.0, 0.0, spin])
    outward = rotation_matrices(pose[None, 3:])[0] @ [1.0, 0.0, 0.0]
    np.testing.assert_allclose(force[:3], 100.0 * spin**2 * 2.0 * outward, atol=50.0 * (spin * h) ** 2)
    np.testing.assert_allclose(force[3:], 0.0, atol=200.0 * (spin * h) ** 2)


def test_a_host_turns_the_thickness_of_a_rod():
    """Angular acceleration across a coupled rod: m (L^2 / 3 + d^2 / 16) about its end, also with few nodes.

    The angle is t^3 / 1000 and small, so that the cubics of the steps have its acceleration to its square.
    """
    kind = RodType(name="spar", diameter=0.8, mass_per_length=50.0)
    sim = moorage.Simulation(
        floating(rods=[rod(1, "coupled", (0, 0, -50), (0, 0, -48), 2)], types=kind, environment=VACUUM)
    )
    sim.initialize()
    for t in (0.1, 0.2, 0.3):
        load = sim.step(t, [0, 0, -50, 0, 1e-3 * t**3, 0], [0, 0, 0, 0, 3e-3 * t**2, 0])
    alpha = 6e-3 * 0.3
    assert load[4] == pytest.approx(-100.0 * (4.0 / 3.0 + 0.64 / 16.0) * alpha, rel=1e-6)
    assert load[0] == pytest.approx(-100.0 * 1.0 * alpha, rel=1e-6)


def test_a_pin_that_a_host_holds_feels_the_pendulum():
    """A rod hangs level at first and swings from its end: at the bottom the pin bears m g (1 + 3 / 2).

    Energy: w^2 = 3 g / L, and m (g + w^2 L / 2) = 2.5 m g; to 1 %, for the passage is sampled at steps of 5 ms.
    """
    swing = rod(1, "coupled-pinned", (0, 0, -50), (2, 0, -50), 8)
    sim = moorage.Simulation(floating(rods=[swing], environment=AIR, start="as-given"))
    sim.initialize()
    up = [sim.step(0.005 * k, [0, 0, -50], [0, 0, 0])[2] for k in range(1, 200)]
    assert -min(up) == pytest.approx(2.5 * 100.0 * 9.80665, rel=0.01)


def test_lines_and_bodies_together_and_a_step_tried_again():
    """Newton's third law between what a host holds: a cable between a coupled body and a coupled point."""
    cable = LineType(name="rope", diameter=0.05, mass_per_length=5.0, axial_stiffness=1e6, axial_damping_ratio=0.5)
    model = floating(
        [body(kind="coupled")],
        environment=VACUUM,
        line_types=cable,
        points=[Point(id=1, kind="fixed", body=1, position=(1.0, 0.0, 0.0)),
                Point(id=2, kind="coupled", position=(11.0, 0.0, -50.0))],
        lines=[Line(id=1, end_a=Attachment("point", 1), end_b=Attachment("point", 2),
                    sections=(Section(line_type="rope", length=9.9, segments=5),))],
    )  # fmt: skip
    sim = moorage.Simulation(model)
    assert sim.degrees_of_freedom == (("body", 1, 6), ("point", 2, 3))
    np.testing.assert_array_equal(sim.points, [2])
    force = sim.initialize()
    pull = 1e6 * (10.0 / 9.9 - 1.0)
    np.testing.assert_allclose(force, [pull, 0, 0, 0, 0, 0, -pull, 0, 0], atol=1e-6 * pull)
    state, pose = sim.save(), sim.position
    target = pose + np.array([0, 0.05, 0, 0, 0, 0.01, 0, 0, 0])
    first = sim.step(0.1, target, np.zeros(9))
    np.testing.assert_array_equal(sim.position, target)
    sim.restore(state)
    np.testing.assert_array_equal(sim.position, pose)
    np.testing.assert_array_equal(sim.step(0.1, target, np.zeros(9)), first)
    with pytest.raises(moorage.SimulationError, match="9 finite numbers \\(6 of body 1, 3 of point 2\\)"):
        sim.step(0.2, target[:6], np.zeros(6))
    with pytest.raises(moorage.SimulationError, match="NaN"):
        sim.step(0.2, target * np.nan, np.zeros(9))


def test_the_courant_number_is_that_of_lines(system):
    """Rods have no waves along them: of two segments of 3 m and 25/3 m the shorter is the stiffer."""
    moordyn.SetDt(system, 0.01)
    number = moordyn.GetCFL(system)
    mass = 0.5 * 3.0 * 35.0  # of the end node of the short line, kg
    assert number == pytest.approx(0.01 * (5515288.0 / 3.0 / mass) ** 0.5)
    moordyn.SetCFL(system, 2.0 * number)
    assert moordyn.GetDt(system) == pytest.approx(0.02)


def test_handles_of_one_kind_are_not_taken_for_another(system):
    line, point, body = (get(system, 1) for get in (moordyn.GetLine, moordyn.GetPoint, moordyn.GetBody))
    for call in (moordyn.GetBodyPos, moordyn.GetRodForce, moordyn.GetPointForce):
        with pytest.raises(TypeError, match="is wanted, not Line"):
            call(line)
    with pytest.raises(TypeError, match="a line is wanted, not Body"):
        moordyn.GetLineNodePos(body, 0)
    with pytest.raises(TypeError, match="a line is wanted, not Point"):
        moordyn.BreakLine(system, point, point)
    with pytest.raises(TypeError):
        moordyn.GetLine(system, 1.5)


def test_a_point_without_mass_keeps_a_line(path):
    path.write_text(path.read_text().replace("-2   20.0  0", "-2   0.0   0"))
    system = moordyn.Create(str(path))
    moordyn.Init(system, [], [])
    with pytest.raises(RuntimeError, match="point 1 would be left with neither lines nor mass"):
        moordyn.BreakLine(system, moordyn.GetPoint(system, 1), moordyn.GetLine(system, 1))
