"""The comparison with other meshers: every row of peers.csv has a model, and misses are told column by column."""
import math
import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import peers  # noqa: E402

BEST = {"mean_sj": 0.98, "min_sj": 0.6, "irregular": 4.4, "cv": 0.112, "outside": 2.2, "triangles": 0.0}


class Comparison(unittest.TestCase):
    def test_every_row_has_a_model_with_an_area(self):
        areas = {name: 1.0 for row in peers.table() for name in (row["model"], *peers.EXAMPLE.values())}
        for row in peers.table():
            path, area = peers.model_and_area(row["model"], areas)
            self.assertTrue(os.path.exists(path), path)
            self.assertTrue(math.isfinite(area) and area > 0)

    def test_equal_to_the_decimals_of_the_table_is_no_miss(self):
        ours = {"mean_sj": 0.97951, "min_sj": 0.601, "irregular": 4.44, "cv": 0.1124, "outside": 2.24, "triangles": 0}
        cells, misses = peers.cells_of(ours, BEST)
        self.assertEqual(misses, [])
        self.assertEqual(cells[0], "0.980 (0.980)")

    def test_misses_are_named_and_set_in_bold(self):
        ours = {"mean_sj": 0.96, "min_sj": 0.7, "irregular": 4.4, "cv": 0.2, "outside": 9, "triangles": 3}
        cells, misses = peers.cells_of(ours, BEST)
        self.assertEqual(misses, ["mean_sj", "cv", "outside", "triangles"])
        self.assertEqual(cells[0], "**0.960** (0.980)")

    def test_without_a_peer_nothing_is_missed(self):
        ours = {column: 1.0 for column in BEST}
        cells, misses = peers.cells_of(ours, {column: None for column in BEST})
        self.assertEqual(misses, [])
        self.assertEqual(cells[0], "1.000 (none)")


if __name__ == "__main__":
    unittest.main()
