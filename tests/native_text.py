"""A chain from the seabed to a moved point, as a native file in whose environment something is to be put."""

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
