"""One phenomenon a file: parameters, force and tangent, energy where there is one."""
