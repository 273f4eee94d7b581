"""The report of a run: it holds the numbers of the result, what to doubt, and nothing from elsewhere."""

import dataclasses
import re
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from matplotlib.backends.backend_agg import FigureCanvasAgg
from moorings import fixed, kind, line, mooring
from typer.testing import CliRunner

import moorage
from moorage.cli import app
from moorage.model import Attachment, Failure
from moorage.reporting import doubts, report_page, write_pdf
from moorage.reporting.content import Table, sections
from moorage.viewer import scene_of

EXAMPLES = Path(__file__).parents[2] / "examples"
VOID = {"meta", "img", "br"}


@pytest.fixture(scope="module")
def run():
    model = moorage.read(EXAMPLES / "oc4" / "oc4.dat")
    motion = moorage.Motion.from_harmonics(10.0, ramp=5.0, surge=(2.0, 8.0))
    return moorage.simulate(model, duration=10.0, motion=motion)


class Reader(HTMLParser):
    """Checks that every tag is closed in its turn, and collects text and addresses."""

    def __init__(self, page):
        super().__init__()
        self.open, self.text, self.addresses = [], [], []
        self.feed(page)
        assert not self.open

    def handle_starttag(self, tag, attrs):
        self.addresses += [value for name, value in attrs if name in ("src", "href")]
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text.append(data)


def test_the_report_has_what_the_result_says(run):
    read = Reader(report_page(run))
    text = " ".join(read.text)
    for row in moorage.results.line_summaries(run):
        assert f"{row.fairlead.maximum / 1e3:.1f}" in read.text
        assert f"{row.anchor.mean / 1e3:.1f}" in read.text
    assert "depth 200 m" in text
    assert "6 (3 fixed, 3 coupled)" in text
    assert run.attrs["input_sha256"] in read.text
    assert "835.5" in read.text
    assert "Warnings" not in read.text
    assert run.attrs["input"].strip()[:40] in text


def test_the_figures_are_in_the_page(run):
    read = Reader(report_page(run))
    assert len(read.addresses) == 4
    assert all(address.startswith("data:image/png;base64,iVBOR") for address in read.addresses)


def test_what_cannot_be_drawn_is_said(run):
    text = " ".join(Reader(report_page(run.drop_vars(["node_position", "segment_tension"]))).text)
    assert len(re.findall("not drawn", text)) == 2
    assert "--save all" in text


def test_titles_are_text_and_not_tags(run):
    assert "<script>" not in report_page(run.assign_attrs(title="<script>alert(1)</script>"))


def test_doubts(run):
    assert doubts(run) == []
    cut = run.isel(time=slice(0, 50)).assign_attrs(status="interrupted")
    assert "4.9 s of 10 s" in doubts(cut)[0]
    slack = run.copy()
    slack["minimum_tension"] = 0.0 * run["minimum_tension"]
    assert doubts(slack) == ["lines that went slack: 1, 2, 3"]
    assert "lines that went slack: 1, 2, 3" in Reader(report_page(slack)).text


def test_tensions_above_the_breaking_load_are_doubts(run):
    strength = xr.full_like(run["unstretched_length"], 0.5 * run["segment_tension"].max().item())
    assert "more than its minimum breaking load" in doubts(run.assign_coords(breaking_load=strength))[0]


def test_lines_that_come_off_are_told():
    """In the result, in its report and on its page."""
    whole = mooring(
        kind(), (fixed(1, 0.0, 0.0, -50.0), fixed(2, 40.0, 0.0, -20.0)), (line(1, 1, 2, ("rope", 52.0, 2)),)
    )
    off = Failure(id=1, attachment=Attachment("point", 2), lines=(1,), time=0.5, tension=9e6)
    ds = moorage.simulate(dataclasses.replace(whole, failures=(off,)), duration=1.0)
    told = "line 1 from point 2 at 0.5 s or at 9000 kN"
    assert ds.attrs["failures"] == told
    assert told in Reader(report_page(ds)).text
    assert scene_of(ds).meta["notes"] == [f"Comes off: {told}."]


def test_bodies_and_rods_have_their_table(run):
    place = np.tile([1.234, 0.0, -5.0], (run.sizes["time"], 1, 1))
    turn = np.zeros_like(place) - 1e-9
    ds = run.assign(
        body_position=(("time", "body", "xyz"), place), body_rotation=(("time", "body", "xyz"), turn)
    ).assign_coords(body=[3])
    text = Reader(report_page(ds)).text
    assert {"body 3", "1.23", "-5.00"} <= set(text)
    assert "-0.00" not in text


class Printed:
    """Stands for the PDF: what is on its pages, and whether it stays on them."""

    def __init__(self, *_, **__):
        self.pages = []

    def __enter__(self):
        return self

    def __exit__(self, *_):
        pass

    def savefig(self, figure):
        self.pages.append([words.get_text().replace("\\$", "$") for words in figure.texts])
        if not figure.axes:
            for words in figure.texts:
                box = words.get_window_extent(FigureCanvasAgg(figure).get_renderer()).transformed(
                    figure.transFigure.inverted()
                )
                assert min(box.x0, box.y0) > 0.0, words
                assert max(box.x1, box.y1) < 1.0, words


def test_the_pdf_says_what_the_page_says(tmp_path, monkeypatch):
    """All cells of all tables are on its pages, which hold 60 lines each, and nothing hangs over their edges."""
    ends = [point for k in range(60) for point in (fixed(2 * k + 1, 0.0, k, -50.0), fixed(2 * k + 2, 40.0, k, -20.0))]
    lines = [line(k + 1, 2 * k + 1, 2 * k + 2, ("rope", 52.0, 2)) for k in range(60)]
    many = moorage.simulate(mooring(kind(), ends, lines, water_depth=50.0), duration=4.0)
    long = many.assign_attrs(
        unused_options="; ".join(["dtM = 0.001 (its own step)"] * 30), title="5 $ in $ " + "x" * 200
    )
    printed = Printed()
    monkeypatch.setattr("moorage.reporting.pdf_pages.PdfPages", lambda *_, **__: printed)
    write_pdf(long, tmp_path / "run.pdf")
    words = {text for page in printed.pages for text in page}
    for blocks in sections(long).values():
        for block in blocks:
            if isinstance(block, Table):
                assert {cell for row in block.rows for cell in row} <= words
                assert block.caption in words
    pages = [page for page in printed.pages if len(page) > 1]
    assert len(pages) > 3  # of text: 60 lines in three tables
    assert sum("lowest" in page or "min" in page for page in pages) >= 3  # a table on a new page has its head again
    assert sum(len(page) == 1 for page in printed.pages) == 4  # figures
    assert "".join(text for text in pages[0] if set(text) == {"x"}) in "x" * 200


def test_a_pdf_is_written(run, tmp_path):
    path = moorage.report(run, tmp_path / "run.pdf")
    data = path.read_bytes()
    assert data.startswith(b"%PDF-")
    assert data.count(b"/Type /Page ") == 5  # text and four figures
    with pytest.raises(moorage.ResultError, match=r"a report is an \.html or a \.pdf"):
        moorage.report(run, tmp_path / "run.doc")


def test_a_report_of_statics_is_refused():
    ds = moorage.solve_statics(moorage.read(EXAMPLES / "oc4" / "oc4.dat"))
    with pytest.raises(moorage.ResultError, match="static solution"):
        moorage.report(ds)


def test_waves_and_current_are_told():
    ds = moorage.simulate(moorage.read(EXAMPLES / "waves" / "cable_in_waves.yaml"), duration=5.0)
    text = " ".join(Reader(report_page(ds)).text)
    assert "achieved Hs" in text
    assert "m/s at z = 0 m" in text


def test_a_model_without_a_file_has_no_input(run):
    text = " ".join(Reader(report_page(run.assign_attrs(input="", input_file="", input_format="native"))).text)
    assert "made in Python (native)" in text
    assert "SHA-256" not in text
    assert "Input" not in text


def test_a_cable_has_its_table():
    ds = moorage.simulate(moorage.read(EXAMPLES / "lazy_wave" / "lazy_wave.yaml"), duration=1.0)
    text = Reader(report_page(ds)).text
    assert "Largest during the run" in text
    assert f"{ds['curvature'].max().item():.4f}" in text
    assert f"{1.0 / ds['curvature'].max().item():.2f}" in text
    assert f"{ds['fairlead_tension'].max().item() / 1e3:.1f}" in text


def test_the_command_writes_beside_the_result(run, tmp_path, monkeypatch):
    run.to_netcdf(tmp_path / "run.nc")
    monkeypatch.chdir(tmp_path)
    for _ in range(2):
        done = CliRunner().invoke(app, ["report", "run.nc"])
        assert done.exit_code == 0, done.output
    assert Reader((tmp_path / "run-report.html").read_text("utf-8")).text
    assert moorage.report(run, "again.html") == Path("again.html")
    wrong = CliRunner().invoke(app, ["report", "run.nc", "-o", "no/folder.html"])
    assert wrong.exit_code == 2
    assert "cannot write" in wrong.output
