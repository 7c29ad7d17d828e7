"""Programs that render a lowered scene: found, run within limits, listened to, and their results kept."""
