"""`python3 -m sundrape_postproc` and `sundrape-postproc` are the same command."""

import sys

from .cli import main

sys.exit(main())
