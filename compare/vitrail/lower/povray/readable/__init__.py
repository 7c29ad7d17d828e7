"""One commented scene file for a person: the author's names and units, POV-Ray's own photons and dispersion."""
