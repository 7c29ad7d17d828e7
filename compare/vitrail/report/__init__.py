"""One static folder that shows a run: it opens from disk, asks no network, and computes nothing."""
