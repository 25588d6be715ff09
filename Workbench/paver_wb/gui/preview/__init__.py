"""What is seen of a model before it is meshed: contacts of its parts, and what is small. Over the 3D view, never a part of the
document."""
