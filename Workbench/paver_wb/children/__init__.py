"""What belongs to a mesh object and refers to parts of what is meshed."""
