"""Known defects, put in one at a time, to see which of them the verdicts catch and by what name."""
