"""Names of output channels, in the spellings of both programs."""

import pytest

from moorage.model.channels import Channel, parse_channel


@pytest.mark.parametrize(
    ("name", "channel"),
    [
        ("FairTen1", Channel("line", 1, -1, "TEN")),
        ("ANCHTEN12", Channel("line", 12, 0, "TEN")),
        ("L1N10T", Channel("line", 1, 10, "TEN")),
        ("Line2N5pX", Channel("line", 2, 5, "PX")),
        ("LINE1NBPZ", Channel("line", 1, -1, "PZ")),
        ("LINE1NAFX", Channel("line", 1, 0, "FX")),
        ("LINE1VY", Channel("line", 1, 0, "VY")),
        ("LINE2TENA", Channel("line", 2, 0, "TENA")),
        ("L2TB", Channel("line", 2, -1, "TENB")),
        ("Con4Fx", Channel("point", 4, None, "FX")),
        ("P3AZ", Channel("point", 3, None, "AZ")),
        ("POINT3T", Channel("point", 3, None, "TEN")),
        ("ROD1PX", Channel("rod", 1, None, "PX")),
        ("R1N3FX", Channel("rod", 1, 3, "FX")),
        ("ROD2NBVZ", Channel("rod", 2, -1, "VZ")),
        ("ROD2SUB", Channel("rod", 2, None, "SUB")),
        ("BODY1RAX", Channel("body", 1, None, "RAX")),
        ("B1RZ", Channel("body", 1, None, "RZ")),
    ],
)
def test_known(name, channel):
    assert parse_channel(name) == channel


@pytest.mark.parametrize(
    "name", ["", "FAIRTEN", "LINEPX", "L1", "L1N5Q", "BODY1N2PX", "FOO1PX", "L1N5", "POINT1SUB", "1PX"]
)
def test_unknown(name):
    assert parse_channel(name) is None
