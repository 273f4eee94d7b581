"""Native files as text, and the check that a change makes one wrong."""

import pytest

from moorage.errors import ModelError
from moorage.io import read

# a chain from the seabed to a moved point, in whose environment something is to be put
CHAIN = """\
moorage: 1
environment:
  water_depth: 100
  {what}
line_types:
  chain: {{diameter: 0.08, mass_per_length: 113, axial_stiffness: 7.5e8}}
points:
  - {{id: 1, kind: fixed, position: [-300, 0, seabed]}}
  - {{id: 2, kind: coupled, position: [0, 0, -10]}}
lines:
  - {{id: 1, end_a: 1, end_b: 2, sections: [{{line_type: chain, length: 330, segments: 10}}]}}
"""


def check_refused(tmp_path, text: str, change: tuple[str, str], message: str) -> None:
    """Check that a file with one text in place of another is refused with a message, and always a remedy."""
    old, new = change
    assert old in text
    path = tmp_path / "model.yaml"
    path.write_text(text.replace(old, new))
    with pytest.raises(ModelError, match=message) as caught:
        read(path)
    assert all(problem.remedy for problem in caught.value.problems)
