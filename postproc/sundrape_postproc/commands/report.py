"""report: one page on a run, for a browser or for paper."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from ..display import ensure_display
from ..errors import PostprocError
from . import options as common

HELP = "one page on a run: what ran, what came of it, how far to trust it, and where it failed"


def configure(parser: argparse.ArgumentParser) -> None:
    common.add_result(parser)
    common.add_output(parser, (".html", ".pdf"))


def run(options: argparse.Namespace, arguments: Sequence[str]) -> None:
    from ..load import load

    result = load(options.result)
    ensure_display()
    from .. import report, report_html, report_pdf

    made = report.report(result)
    if options.output.suffix.lower() == ".pdf":
        report_pdf.write(made, options.output)
        return
    try:
        options.output.write_text(report_html.page(made), encoding="utf-8")
    except OSError as trouble:
        raise PostprocError(f"{options.output}: cannot be written: {trouble.strerror or trouble}") from trouble
