"""Measure, print and store: `python -m benchmarks [--quick] [TABLE ...]`."""

from __future__ import annotations

import argparse
import importlib
import time
from pathlib import Path

from benchmarks.effort import FULL, QUICK
from benchmarks.programs import ROOT
from benchmarks.report import as_text, limits_table, store

TABLES = ("chains", "cable", "statics", "hour", "spread", "coupling", "startup", "accuracy", "waves", "seabed")


def main() -> None:
    """Run the tables that are asked for."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("tables", nargs="*", metavar="TABLE", help=f"which to measure: {', '.join(TABLES)} (all)")
    parser.add_argument(
        "--quick", action="store_true", help="small sizes, to see that everything works; not for timing"
    )
    parser.add_argument(
        "--results", type=Path, default=ROOT / "benchmarks" / "results", help="folder of the JSON files"
    )
    parser.add_argument("--page", type=Path, default=ROOT / "docs" / "benchmarks.md", help="the page of all tables")
    chosen = parser.parse_args()
    unknown = [name for name in chosen.tables if name not in TABLES]
    if unknown:
        parser.error(f"no table {', '.join(unknown)}; there are {', '.join(TABLES)}")
    measured = []
    for name in chosen.tables or TABLES:
        begin = time.perf_counter()
        table = importlib.import_module(f"benchmarks.tables.{name}").measure(QUICK if chosen.quick else FULL)
        print(f"{as_text(table)}\n({time.perf_counter() - begin:.0f} s)\n", flush=True)
        measured.append(table)
        store(measured, chosen.results, chosen.page)
    print(as_text(limits_table(measured)))


main()
