"""Pure functions from radiance samples to numbers with units, ideals and stated settings."""
