"""Back ends: one scene and one plan become the input of one engine, or are refused."""
