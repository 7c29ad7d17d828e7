"""From two images and a scene to a verdict for each phenomenon; the records here are ``results.json``."""
