"""What every layer may use: the names of the phenomena, vectors, and canonical JSON."""
