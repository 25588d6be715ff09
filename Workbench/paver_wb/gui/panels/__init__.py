"""The parts of the task panels."""
