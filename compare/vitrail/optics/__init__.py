"""Optics as formulas: refraction indices of real glass, the bands that light is split into, colour."""
