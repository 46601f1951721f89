"""JSON reports that sundrape writes beside results."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from .errors import BAD_USE, PostprocError


def read_report(folder: Path, name: str, kind: str) -> dict[str, Any]:
    """FOLDER/name as a dictionary.

    Raises PostprocError: status 3 if it is missing or cannot be read, 2 if it is not JSON of this `kind`.
    """
    path = folder / name
    try:
        report = json.loads(path.read_text(encoding="utf-8"))
    except OSError as trouble:
        raise PostprocError(f"{path}: {trouble.strerror or trouble}") from trouble
    except ValueError as trouble:
        raise PostprocError(f"{path}: not a {kind}: {trouble}", BAD_USE) from trouble
    if not isinstance(report, dict) or report.get("format") != kind:
        raise PostprocError(f'{path}: not a {kind}: its "format" is not "{kind}"', BAD_USE)
    return report
