"""Results in a browser: one self-contained page in three dimensions."""

from moorage.viewer.assemble import page
from moorage.viewer.scene import Scene, scene_of

__all__ = ["Scene", "page", "scene_of"]
