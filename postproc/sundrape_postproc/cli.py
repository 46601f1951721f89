"""The command line: one subcommand a module of `commands`. Heavy imports wait until arguments and file are known good."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from importlib import import_module

from . import commands
from .errors import FILE_TROUBLE, INTERRUPTED, PostprocError

NEEDED = "apt install python3-h5py python3-numpy python3-matplotlib python3-shapely python3-vtk9 xvfb"


def main(arguments: Sequence[str] | None = None) -> int:
    """Exit status: 0 done, 2 bad command line or not a result file, 3 file trouble, 130 interrupted."""
    arguments = list(sys.argv[1:] if arguments is None else arguments)
    try:
        options = _parser().parse_args(arguments)
        options.run(options, arguments)
    except PostprocError as error:
        print(error, file=sys.stderr)
        return error.status
    except ImportError as error:
        print(f"{error.name or error} is missing for this python ({sys.executable}): {NEEDED}", file=sys.stderr)
        return FILE_TROUBLE
    except KeyboardInterrupt:
        return INTERRUPTED
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="sundrape_postproc", description="Draw sundrape's result files.")
    subparsers = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    for name in commands.NAMES:
        command = import_module(f".commands.{name}", __package__)
        subparser = subparsers.add_parser(name, help=command.HELP, description=f"Draw {command.HELP}.")
        command.configure(subparser)
        subparser.set_defaults(run=command.run)
    return parser
