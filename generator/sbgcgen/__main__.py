"""Entry point of `python3 -m sbgcgen`."""

import gc
import os
import sys

from sbgcgen.cli import main

gc.disable()  # a run is short, and most of what it creates stays in use
status = main()
sys.stdout.flush()
sys.stderr.flush()
os._exit(status)  # without freeing every object first
