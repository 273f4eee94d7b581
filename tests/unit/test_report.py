"""The report of a run: it holds the numbers of the result, what to doubt, and nothing from elsewhere."""

import re
from html.parser import HTMLParser
from pathlib import Path

import pytest
from typer.testing import CliRunner

import moorage
from moorage.cli import app
from moorage.reporting import doubts, report_page

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
