"""POV-Ray's language: every part of a scene as text."""
