"""python -m paver: the command line."""
import sys

from ._program import run

run(sys.argv[1:])
