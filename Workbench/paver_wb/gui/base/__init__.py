"""What all of the window shares: work beside it, the status bar, steps of undo, small widgets."""
