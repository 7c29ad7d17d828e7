"""What a scene requires of a renderer, with the evidence and the cost, before anything is rendered."""
