"""The process that `benchmarks.programs.call` starts."""

import sys

from benchmarks.programs import serve

serve(*sys.argv[1:])
