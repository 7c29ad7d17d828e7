"""The main line: prepare, lower, run, measure, judge, for one scene or many."""
