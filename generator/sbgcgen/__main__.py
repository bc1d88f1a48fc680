"""Entry point of `python3 -m sbgcgen`."""

import gc
import sys

from sbgcgen.cli import main

gc.disable()  # a run is short, and most of what it creates stays in use
sys.exit(main())
