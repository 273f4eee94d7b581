"""One measurement a file: `measure(effort)` returns its table."""
