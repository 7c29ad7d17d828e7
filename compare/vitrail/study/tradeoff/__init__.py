"""Speed against accuracy: every knob of both engines, its error for each phenomenon and its price in CPU seconds."""
