"""What the figures of both studies share."""

from __future__ import annotations

from matplotlib.axes import Axes

from moorage.plot.style import plain


def dress(ax: Axes, x: str, y: str, title: str = "") -> None:
    """Label axes and take away what carries nothing."""
    plain(ax)
    ax.set_xlabel(x, fontsize=9)
    ax.set_ylabel(y, fontsize=9)
    if title:
        ax.set_title(title, fontsize=9)


def legend_above(ax: Axes, columns: int = 6) -> None:
    """Put the legend over the axes, off the data."""
    ax.legend(
        loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=columns, frameon=False, fontsize=8, borderaxespad=0.2,
        handlelength=1.6, columnspacing=1.2,
    )  # fmt: skip
