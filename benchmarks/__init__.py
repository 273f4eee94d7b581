"""Speed and accuracy of Moorage beside other programs: `python -m benchmarks`."""
