"""A report on A4 pages."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Sequence
from pathlib import Path

import matplotlib.pyplot as plt
from matplotlib.backends.backend_pdf import PdfPages
from matplotlib.figure import Figure

from .errors import PostprocError
from .page import STYLE
from .plot import CELL, INSET, place
from .report import STATUS, Picture, Report

PAPER = (8.27, 11.69)  # inches, A4
MARGIN = 0.7  # inches
WIDTH = PAPER[0] - 2 * MARGIN
LINE = 0.185  # inches between lines of text
FAINT = "#6a6a6a"
GOOD, BAD = "#006b4f", "#a33f00"
LETTERS_AN_INCH = 15.5  # of text at 8.5 points


class Sheets:
    """Pages that are filled from the top."""

    def __init__(self, title: str) -> None:
        self.pages: list[Figure] = []
        self._title = title
        self._turn()

    def _turn(self) -> None:
        self.page = plt.figure(figsize=PAPER, facecolor="white")
        self.pages.append(self.page)
        self.top = PAPER[1] - MARGIN  # inches from below where the next thing goes
        if len(self.pages) > 1:
            self.page.text(MARGIN / PAPER[0], 1 - 0.42 / PAPER[1], self._title, fontsize=7.5, color=FAINT)
        self.page.text(
            1 - MARGIN / PAPER[0], 0.35 / PAPER[1], str(len(self.pages)), fontsize=7.5, color=FAINT, ha="right"
        )

    def room(self, height: float) -> None:
        """Turns the page unless `height` inches are left."""
        if self.top - height < MARGIN:
            self._turn()

    def write(self, text: str, left: float = 0.0, height: float = LINE, **style: object) -> None:
        """One line, `left` inches into it."""
        self.room(height)
        self.words(text, left, **style)
        self.top -= height

    def words(self, text: str, left: float, **style: object) -> None:
        """Text on the line that comes next, without going on to the one after it."""
        place = ((MARGIN + left) / PAPER[0], (self.top - 0.13) / PAPER[1])
        self.page.text(*place, text, va="baseline", parse_math=False, **style)

    def heading(self, text: str) -> None:
        self.room(4 * LINE)
        self.top -= 0.14
        self.write(text, height=1.35 * LINE, fontsize=11, fontweight="bold")

    def rows(self, rows: Sequence[tuple[str, ...]], columns: tuple[float, ...]) -> None:
        """A table whose columns begin at `columns` inches; the last one is wrapped."""
        letters = int((WIDTH - columns[-1]) * LETTERS_AN_INCH)
        for row in rows:
            lines = textwrap.wrap(row[-1], letters) or [""]
            self.room(len(lines) * LINE)
            for k, (text, left) in enumerate(zip(row[:-1], columns)):
                self.words(text, left, color=FAINT if k == 0 else "#2b2b2b")
            for line in lines:
                self.write(line, columns[-1], color="#2b2b2b" if len(row) == 2 else FAINT)

    def pictures(self, pictures: list[Picture], across: int) -> None:
        """In rows, each with its caption below."""
        gap = 0.12
        width = (WIDTH - (across - 1) * gap) / across
        for start in range(0, len(pictures), across):
            row = pictures[start : start + across]
            height = width * max(p.pixels.shape[0] / p.pixels.shape[1] for p in row)
            self.room(height + 1.4 * LINE)
            for k, picture in enumerate(row):
                left = MARGIN + k * (width + gap)
                box = (left / PAPER[0], (self.top - height) / PAPER[1], width / PAPER[0], height / PAPER[1])
                axes = self.page.add_axes(box)
                axes.imshow(picture.pixels, interpolation="antialiased")
                axes.set_axis_off()
            self.top -= height
            for k, picture in enumerate(row):
                self.words(picture.caption, k * (width + gap), fontsize=7, color=FAINT)
            self.top -= 1.4 * LINE


def write(report: Report, path: Path) -> None:
    """Raises PostprocError, status 3, if it cannot be written."""
    with plt.rc_context(STYLE | {"pdf.fonttype": 42}):
        pages = _pages(report)
        try:
            with PdfPages(path, metadata={"Title": report.title, "Creator": "sundrape_postproc"}) as file:
                for page in pages:
                    file.savefig(page, dpi=150)
        except OSError as trouble:
            raise PostprocError(f"{path}: cannot be written: {trouble.strerror or trouble}") from trouble
        finally:
            for page in pages:
                plt.close(page)


def _pages(report: Report) -> list[Figure]:
    sheets = Sheets(report.title)
    for line in textwrap.wrap(report.title, 60):
        sheets.write(line, height=0.3, fontsize=15, fontweight="bold")
    colour = GOOD if report.status == "done" else BAD
    sheets.write(
        STATUS.get(report.status, report.status), height=1.6 * LINE, fontsize=10, fontweight="bold", color=colour
    )
    for line in _failed(report):
        sheets.write(line, color=BAD)
    if report.failed_at is not None:
        sheets.top -= 0.06
        sheets.pictures([report.failed_at], 1)
    sheets.heading("What ran")
    sheets.rows(report.ran, (0, 1.7))
    if report.numbers:
        sheets.heading("How far to trust it")
        sheets.rows(report.numbers, (0, 1.9, 3.1))
    if report.warnings:
        sheets.heading("Warnings")
        sheets.rows([("–", warning) for warning in report.warnings], (0, 0.2))
    sheets.heading("The cloth")
    for row in report.pictures:
        sheets.pictures(row, 3)
    if report.panels:
        _plots(sheets, report)
    if report.statistics:
        sheets.heading("Statistics of the solver")
        sheets.rows(report.statistics, (0, 1.9, 3.1))
    if report.case:
        sheets.heading("The case, as it ran")
        for line in report.case.splitlines():
            for part in textwrap.wrap(line, 108, drop_whitespace=False) or [""]:
                sheets.write(part, height=0.135, fontsize=6.5, family="DejaVu Sans Mono")
    return sheets.pages


def _plots(sheets: Sheets, report: Report) -> None:
    cell = (WIDTH + 0.3, CELL[1])
    sheets.room(cell[1] + 3 * LINE)
    sheets.heading("Over the run")
    for panel in report.panels:
        sheets.room(cell[1])
        place(sheets.page, panel, MARGIN - INSET["left"] / 4, sheets.top - cell[1], cell)
        sheets.top -= cell[1]


def _failed(report: Report) -> Iterator[str]:
    if report.failure is None:
        return
    yield from textwrap.wrap(report.failure.message, int(WIDTH * LETTERS_AN_INCH))
    for label, place_ in report.failure.places:
        yield f"{label} at ({place_[0]:.4g}, {place_[1]:.4g}, {place_[2]:.4g}) m"
    if report.failure.time is not None:
        yield f"t = {report.failure.time:.6g} s"
