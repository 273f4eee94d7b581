"""A run on one page for people, as HTML or PDF."""

from __future__ import annotations

from pathlib import Path

import xarray as xr

from moorage.errors import Problem, ResultError
from moorage.reporting.content import doubts
from moorage.reporting.html_page import report_page
from moorage.reporting.pdf_pages import write_pdf
from moorage.results import open_result

__all__ = ["doubts", "report", "report_page", "write_pdf"]


def report(source: xr.Dataset | str | Path, path: str | Path | None = None) -> Path:
    """Write a report of a run: one HTML page, which needs nothing else and can be printed, or a PDF.

    Parameters
    ----------
    source : xarray.Dataset or path
        What a run returned or wrote.
    path : path, optional
        Where to write, .html or .pdf; by default beside the result, ending in `-report.html`.

    Returns
    -------
    Path
        The report.

    Raises
    ------
    ResultError
        It is no run, or the report cannot be written.
    """
    ds = source if isinstance(source, xr.Dataset) else open_result(source)
    if "time" not in ds["fairlead_tension"].dims:
        raise ResultError(Problem("a report is about a run, and this is a static solution", "take a result of `run`"))
    beside = Path(ds.encoding.get("source") or Path(str(ds.attrs.get("input_file", ""))).name or "mooring")
    target = beside.with_name(f"{beside.stem}-report.html") if path is None else Path(path)
    ending = target.suffix.lower()
    if ending not in (".html", ".htm", ".pdf"):
        raise ResultError(Problem("a report is an .html or a .pdf", "give a name that ends so (-o)", value=str(target)))
    try:
        if ending == ".pdf":
            write_pdf(ds, target)
        else:
            target.write_text(report_page(ds), "utf-8")
    except OSError as error:
        why = error.strerror or error
        raise ResultError(Problem(f"cannot write {target}: {why}", "give another file (-o)")) from error
    return target
