"""One image from many independent passes: constant memory, a known error, and it goes on where it stopped."""
