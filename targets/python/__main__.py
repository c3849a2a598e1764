"""The program: `python3 FOLDER --listen unix:PATH`."""
import os
import sys

from eagerx_part import main  # first: it says what is missing

import nodes

sys.exit(main(nodes.NODES, os.path.dirname(os.path.abspath(__file__))))
