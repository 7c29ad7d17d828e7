"""Scenes through both engines to verdicts: load, plan, lower, render, measure, judge."""
