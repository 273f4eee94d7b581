"""Both papers done again: `python -m studies.bending_2020` and `python -m studies.seabed_2022`."""
