"""The commands, one a module: HELP, `configure(parser)` for its arguments and `run(options, arguments)` that does it.

Their modules import what draws only when they run, so that a bad command line is answered at once.
"""

NAMES = ("picture", "filmstrip", "film", "plot", "report", "overlay", "strip", "drape", "drapes",
    "study", "crosscheck", "view")
