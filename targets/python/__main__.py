"""Program of a part: `python3 FOLDER --listen unix:PATH`."""
import os
import sys

from eagerx_part import main  # first, because it reports missing packages

import nodes

sys.exit(main(nodes.NODES, os.path.dirname(os.path.abspath(__file__))))
