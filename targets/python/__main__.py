"""The program: `python3 FOLDER --listen unix:PATH`."""
import os
import sys

import nodes
from eagerx_part import main

sys.exit(main(nodes.NODES, os.path.dirname(os.path.abspath(__file__))))
