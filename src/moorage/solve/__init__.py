"""Statics, time steps, elimination and stiffness: arrays in, arrays out."""
