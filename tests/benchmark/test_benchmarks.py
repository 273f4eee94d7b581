"""The benchmarks work and print all their rows; nothing is timed here, sizes are small and programs may be missing."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from benchmarks.report import Column, Limit, Table, as_markdown, as_text, limits_table, load, store

ROOT = Path(__file__).parents[2]
ROWS = {
    "chains": 6,
    "cable": 4,
    "statics": 12,
    "hour": 4,
    "spread": 3,
    "coupling": 9,
    "startup": 7,
    "accuracy": 34,
    "waves": 4,
    "seabed": 10,
}
OURS = {
    "chains": "program",
    "cable": "program",
    "statics": "program",
    "coupling": "program",
}  # where other programs have rows too


@pytest.fixture(scope="module")
def output(tmp_path_factory):
    folder = tmp_path_factory.mktemp("benchmarks")
    command = [
        sys.executable,
        "-m",
        "benchmarks",
        "--quick",
        "--results",
        folder / "results",
        "--page",
        folder / "page.md",
    ]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    print(done.stdout)
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
    return folder


@pytest.mark.parametrize("name", ROWS)
def test_all_rows_are_there(name, output):
    stored = json.loads((output / "results" / f"{name}.json").read_text())
    rows, columns = stored["table"]["rows"], stored["table"]["columns"]
    assert len(rows) == ROWS[name]
    assert {"date", "machine", "moorage", "moordyn", "cabledyn"} <= set(stored["conditions"])
    for row in rows:
        assert {key for key, *_ in columns} <= set(row)
        if OURS.get(name) and row[OURS[name]].startswith("Moorage"):
            assert row.get("cpu", row.get("each")) > 0.0


def test_page_has_every_table(output):
    page = (output / "page.md").read_text()
    assert page.count("\n## ") == len(ROWS) + 1
    assert "| promise | measured | limit | unit | verdict |" in page


def test_tables_are_stored_and_read_back(tmp_path):
    table = Table(
        "name", "A title", (Column("a", "what"), Column("b", "ms", ".1f")), [{"a": "x", "b": 1.25}, {"a": "y", "b": None}],
        ("a note",), (Limit("fast", 2.0, 1.5, "s"), Limit("small", None, 1.0, "MB")),
    )  # fmt: skip
    store([table], tmp_path / "results", tmp_path / "docs" / "page.md")
    assert load(tmp_path / "results" / "name.json")[1] == table
    assert as_text(table).splitlines() == ["A title", "what  ms", "x     1.2", "y     -", "a note"]
    assert "| x | 1.2 |" in as_markdown(table)
    assert [row["verdict"] for row in limits_table([table]).rows] == ["MISSED", "not measured"]
