"""From a model to arrays, and from arrays to the forces and tangents of whole lines."""
