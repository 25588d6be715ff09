"""Series of meshes in the window: their runs, the dialog with the table, what the tree shows."""
