"""What tests of every kind share: a small valid MoorDyn file, and the folder of reference data."""

from __future__ import annotations

from pathlib import Path

import pytest

DECK = """\
--------------------- MoorDyn Input File ---------------------
A chain in 200 m
---------------------- LINE TYPES ----------------------------
TypeName   Diam     Mass/m   EA         BA/-zeta   EI        Cd    Ca    CdAx   CaAx
(name)     (m)      (kg/m)   (N)        (N-s/-)    (N-m^2)   (-)   (-)   (-)    (-)
chain      0.0766   113.35   7.536e8    -0.8       0         2.0   0.8   0.4    0.25
---------------------- POINTS --------------------------------
ID    Attachment   X         Y     Z        Mass   Volume   CdA    Ca
(#)   (word)       (m)       (m)   (m)      (kg)   (m^3)    (m^2)  (-)
1     Fixed        -837.6    0.0   -200.0   0      0        0      0
2     Coupled      -40.868   0.0   -14.0    0      0        0      0
---------------------- LINES ---------------------------------
ID    LineType   AttachA   AttachB   UnstrLen   NumSegs   LineOutputs
(#)   (name)     (ID)      (ID)      (m)        (-)       (-)
1     chain      1         2         835.35     20        p
---------------------- OPTIONS -------------------------------
200.0    WtrDpth   water depth (m)
9.80665  g         gravity
0.001    dtM       time step
---------------------- OUTPUTS -------------------------------
FairTen1
L1N10PX
---------------------- need this line ------------------------
"""


@pytest.fixture
def deck(tmp_path):
    """Write the small MoorDyn file with parts of its text replaced, and return its path."""

    def write(*replacements: tuple[str, str], name: str = "model.dat") -> Path:
        text = DECK
        for old, new in replacements:
            assert old in text, f"{old!r} is not in the deck"
            text = text.replace(old, new, 1)
        path = tmp_path / name
        path.write_text(text, "utf-8")
        return path

    return write


@pytest.fixture(scope="session")
def reference():
    """Return the folder of reference data beside the project, or skip."""
    folder = Path(__file__).parents[2] / "shared" / "reference"
    if not folder.is_dir():
        pytest.skip("no reference data: ../shared/reference does not stand beside the project")
    return folder
