"""Entry point of `python3 -m sbgcgen`."""

import sys

from sbgcgen.cli import main

sys.exit(main())
