"""POV-Ray's photons and radiosity: spacing, flux steps, depth."""
