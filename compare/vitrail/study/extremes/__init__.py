"""The stability atlas: along each axis, the range in which each engine's invariant holds, found by bisection."""
