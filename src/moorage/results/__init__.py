"""Records of a run as labelled datasets: in memory, streamed to disk, and back."""

from moorage.results.bed_check import lines_off_the_grid, lines_off_the_grid_now, warn_of_lines_off_the_grid
from moorage.results.bend_check import TightBend, tight_bends, warn_of_tight_bends
from moorage.results.bending import bending_of
from moorage.results.cable_report import CableReport, cable_reports
from moorage.results.cables import Cable, cables
from moorage.results.channels import plan_outputs, watch_list
from moorage.results.checkpoint import (
    Checkpoint,
    checkpoint_path,
    load_checkpoint,
    remove_checkpoint,
    save_checkpoint,
)
from moorage.results.columns import Layout
from moorage.results.dataset import join_columns, line, static_dataset, to_dataset
from moorage.results.envelopes import envelope
from moorage.results.index import Index, make_index
from moorage.results.load_check import overloads, warn_of_overloads
from moorage.results.memory import MemoryResult
from moorage.results.modes import modes_report, stiffness_report
from moorage.results.moordyn_out import MoordynOut
from moorage.results.object_report import ObjectSummary, object_summaries
from moorage.results.provenance import fingerprint, run_attributes
from moorage.results.reader import open_result
from moorage.results.sea import sea_attributes, warn_of_repetition, warn_of_short_current
from moorage.results.seabed import Seabed, seabed_of
from moorage.results.seabed_report import SeabedReport, seabed_reports
from moorage.results.statistics import LineSummary, Summary, has_static_tensions, line_summaries, static_report
from moorage.results.vtk import write_vtk
from moorage.results.writer import StreamWriter

__all__ = [
    "Cable",
    "CableReport",
    "Checkpoint",
    "Index",
    "Layout",
    "LineSummary",
    "MemoryResult",
    "MoordynOut",
    "ObjectSummary",
    "Seabed",
    "SeabedReport",
    "StreamWriter",
    "Summary",
    "TightBend",
    "bending_of",
    "cable_reports",
    "cables",
    "checkpoint_path",
    "envelope",
    "fingerprint",
    "has_static_tensions",
    "join_columns",
    "line",
    "line_summaries",
    "lines_off_the_grid",
    "lines_off_the_grid_now",
    "load_checkpoint",
    "make_index",
    "modes_report",
    "object_summaries",
    "open_result",
    "overloads",
    "plan_outputs",
    "remove_checkpoint",
    "run_attributes",
    "save_checkpoint",
    "sea_attributes",
    "seabed_of",
    "seabed_reports",
    "static_dataset",
    "static_report",
    "stiffness_report",
    "tight_bends",
    "to_dataset",
    "warn_of_lines_off_the_grid",
    "warn_of_overloads",
    "warn_of_repetition",
    "warn_of_short_current",
    "warn_of_tight_bends",
    "watch_list",
    "write_vtk",
]
