"""A report as one page for browsers and printers: everything is in the file, nothing is asked of any server."""

from __future__ import annotations

import base64
import html
import io
from collections.abc import Iterable

import matplotlib.pyplot as plt
from PIL import Image

from .page import STYLE
from .plot import CELL, Panel, place
from .report import STATUS, Picture, Report

STYLE_SHEET = """
:root { --ink: #2b2b2b; --faint: #6a6a6a; --line: #dcdcdc; --good: #006b4f; --bad: #a33f00; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 1.2rem; max-width: 72rem; color: var(--ink); background: #fff;
       font: 15px/1.45 "DejaVu Sans", Verdana, system-ui, sans-serif; }
h1 { font-size: 1.5rem; margin: 0 0 .3rem; }
h2 { font-size: 1.1rem; margin: 2rem 0 .6rem; padding-bottom: .2rem; border-bottom: 1px solid var(--line); }
.status { display: inline-block; padding: .1rem .7rem; border-radius: 1rem; font-weight: bold;
          color: #fff; background: var(--bad); }
.status.done { background: var(--good); }
.failure { margin: 1rem 0; padding: .8rem 1rem; border-left: .35rem solid var(--bad); background: #fdf3ec;
           overflow-wrap: anywhere; }
.failure p { margin: .3rem 0; }
figure { margin: 0; }
figcaption { font-size: .85rem; color: var(--faint); padding: .25rem 0 .5rem; }
img { display: block; width: 100%; height: auto; }
.pictures { display: grid; gap: .6rem; grid-template-columns: repeat(3, 1fr); }
.plots { display: grid; gap: .6rem; grid-template-columns: repeat(2, 1fr); }
table { border-collapse: collapse; width: 100%; font-size: .9rem; }
th, td { text-align: left; vertical-align: top; padding: .3rem .8rem .3rem 0; border-bottom: 1px solid var(--line); }
th { font-weight: normal; color: var(--faint); }
td.value { white-space: nowrap; font-variant-numeric: tabular-nums; }
td.what { color: var(--faint); }
ul { padding-left: 1.2rem; }
pre { overflow-x: auto; background: #f6f6f6; padding: .8rem; font-size: .8rem; line-height: 1.35; }
summary { cursor: pointer; }
@media (max-width: 46rem) {
  body { padding: .8rem; }
  .pictures, .plots { grid-template-columns: 1fr; }
  .table3 tr { display: grid; grid-template-columns: 1fr auto; border-bottom: 1px solid var(--line); }
  .table3 th, .table3 td { border: 0; padding-bottom: .1rem; }
  .table3 th { color: var(--ink); }
  .table3 td.value { padding-right: 0; text-align: right; }
  .table3 td.what { grid-column: 1 / -1; font-size: .85rem; padding-top: 0; }
}
@media print {
  @page { size: A4; margin: 14mm; }
  body { padding: 0; max-width: none; font-size: 9.5pt; }
  h2 { break-after: avoid; }
  figure, tr, .failure { break-inside: avoid; }
  .status, .failure { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  .pictures { grid-template-columns: repeat(3, 1fr); }
  .plots { grid-template-columns: repeat(2, 1fr); }
  pre { white-space: pre-wrap; font-size: 7.5pt; }
  details::details-content { display: block; content-visibility: visible; }
}
"""


def page(report: Report) -> str:
    """The whole document."""
    parts = [
        f"<h1>{_text(report.title)}</h1>",
        f'<p><span class="status {_text(report.status)}">{_text(STATUS.get(report.status, report.status))}</span></p>',
        _failure(report),
        _section("What ran", _table([(name, value) for name, value in report.ran])),
        _section("How far to trust it", _table(report.numbers)),
        _section("Warnings", _list(report.warnings)),
        _section("The cloth", "".join(_grid("pictures", map(_picture, row)) for row in report.pictures)),
        _section("Over the run", _grid("plots", map(_plot, report.panels))),
        _section("Statistics of the solver", _table(report.statistics)),
        _section(
            "The case", f"<details><summary>as it ran, in TOML</summary><pre>{_text(report.case)}</pre></details>"
        ),
    ]
    return "\n".join(
        [
            "<!DOCTYPE html>",
            '<html lang="en"><head><meta charset="utf-8">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            f"<title>{_text(report.title)}</title><style>{STYLE_SHEET}</style></head><body>",
            *filter(None, parts),
            "</body></html>\n",
        ]
    )


def _text(text: str) -> str:
    return html.escape(str(text))


def _section(title: str, body: str) -> str:
    return f"<section><h2>{_text(title)}</h2>\n{body}</section>" if body else ""


def _failure(report: Report) -> str:
    if report.failure is None:
        return ""
    places = "; ".join(
        f"{label} at ({place[0]:.4g}, {place[1]:.4g}, {place[2]:.4g}) m" for label, place in report.failure.places
    )
    picture = _picture(report.failed_at) if report.failed_at else ""
    where = f"<p><b>Where:</b> {_text(places)}</p>" if places else ""
    when = f"<p><b>When:</b> t = {report.failure.time:.6g} s</p>" if report.failure.time is not None else ""
    return f'<div class="failure"><p><b>What:</b> {_text(report.failure.message)}</p>{where}{when}</div>{picture}'


def _table(rows: Iterable[tuple[str, ...]]) -> str:
    lines = []
    for name, value, *what in rows:
        cells = f'<th scope="row">{_text(name)}</th><td class="value">{_text(value)}</td>'
        lines.append(f"<tr>{cells}{''.join(f'<td class=what>{_text(text)}</td>' for text in what)}</tr>")
    return f'<table class="table3">{"".join(lines)}</table>' if lines else ""


def _list(items: Iterable[str]) -> str:
    lines = "".join(f"<li>{_text(item)}</li>" for item in items)
    return f"<ul>{lines}</ul>" if lines else ""


def _grid(kind: str, items: Iterable[str]) -> str:
    cells = "\n".join(items)
    return f'<div class="{kind}">{cells}</div>' if cells else ""


def _picture(picture: Picture) -> str:
    file = io.BytesIO()
    Image.fromarray(picture.pixels).save(file, "JPEG", quality=88)
    return _figure("image/jpeg", file.getvalue(), picture.caption, picture.caption)


def _plot(panel: Panel) -> str:
    with plt.rc_context(STYLE | {"svg.hashsalt": panel.title}):
        figure = plt.figure(figsize=CELL, facecolor="white")
        place(figure, panel, 0, 0, CELL)
        file = io.BytesIO()
        figure.savefig(file, format="svg", metadata={"Date": None})
        plt.close(figure)
    return _figure("image/svg+xml", file.getvalue(), panel.title, "")


def _figure(kind: str, data: bytes, title: str, caption: str) -> str:
    source = f"data:{kind};base64,{base64.b64encode(data).decode()}"
    below = f"<figcaption>{_text(caption)}</figcaption>" if caption else ""
    return f'<figure><img src="{source}" alt="{_text(title)}">{below}</figure>'
