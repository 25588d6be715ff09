"""Series of solutions, one per module: `compute(stored)` gives the results, `draw(results, folder)` the pictures,
`tables(results)` the page's tables by name."""
