"""One file for each family of shapes: what a placed shape answers when the world is asked about it."""
