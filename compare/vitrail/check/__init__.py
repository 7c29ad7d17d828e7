"""Everything that must hold before a scene counts as good."""
