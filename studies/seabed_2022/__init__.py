"""Housner et al. 2022, "Seabed bathymetry and friction modeling in MoorDyn"."""
