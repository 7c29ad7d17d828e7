"""What the translation to POV-Ray approximates, and by how much."""
