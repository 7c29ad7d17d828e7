"""What cannot be translated to POV-Ray, refused with the line of the scene."""
