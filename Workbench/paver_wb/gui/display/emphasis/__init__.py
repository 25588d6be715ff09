"""What draws the eye: the banner of meshes that are out of date, rings and labels at places, parts of a mesh alone."""
