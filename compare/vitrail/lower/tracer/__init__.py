"""Back end for our tracer: the scene as canonical JSON."""

from vitrail.lower.tracer.lower import lower_tracer

__all__ = ["lower_tracer"]
