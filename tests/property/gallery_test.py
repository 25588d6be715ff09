"""The models of the gallery that are shipped: meshed as the page says, sound, and closed where they are unions."""
import importlib.machinery
import importlib.util
import os
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../support"))
import runs  # noqa: E402

FOLDER = os.path.join(runs.EXAMPLES, "gallery")
UNION = ("--connect", "union")
# (model, options, separate meshes)
MESHES = [("plate_triangular_hole.step", ("--frequency", "6GHz"), 1), ("plate_small_holes.step", ("--frequency", "3GHz"), 1),
          ("pyramid_on_block.step", ("--frequency", "3GHz"), 1), ("reflectarray.brep", ("--frequency", "10GHz"), 1),
          ("microstrip_filter.step", ("--frequency", "10GHz"), 1), ("truncated_cone_sphere.step", ("--frequency", "10GHz"), 1),
          ("conesphere_slot.step", ("--frequency", "869MHz"), 1), ("satellite.step", ("--frequency", "300MHz"), 1),
          ("armoured_vehicle.step", ("--frequency", "100MHz", *UNION), 1), ("airplane.step", ("--frequency", "60MHz", *UNION), 1),
          ("drone.step", ("--frequency", "200MHz", *UNION), 1)]


def program():
    """scripts/gallery as a module."""
    loader = importlib.machinery.SourceFileLoader("gallery", os.path.join(runs.ROOT, "scripts", "gallery"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("gallery", loader))
    loader.exec_module(module)
    return module


class Gallery(unittest.TestCase):
    def test_all_meshes_are_sound(self):
        self.assertEqual({name for name, _, _ in MESHES}, {name for name in os.listdir(FOLDER) if name.endswith((".step", ".brep"))})
        with tempfile.TemporaryDirectory() as folder:
            for name, options, meshes in MESHES:
                with self.subTest(model=name):
                    run = runs.paver(os.path.join(FOLDER, name), os.path.join(folder, "a.msh"), *options)
                    self.assertEqual((run.code, run.report["verdict"], len(run.report["components"])), (0, "sound", meshes))
                    if "union" in options:
                        self.assertTrue(run.report["quality"]["watertight"])

    def test_the_lowest_frequency_gives_as_many_elements_as_faces(self):
        with tempfile.TemporaryDirectory() as folder:
            run = runs.paver(os.path.join(FOLDER, "pyramid_on_block.step"), os.path.join(folder, "a.msh"), "--size", "1e6")
            self.assertEqual((len(run.mesh.quads), len(run.mesh.triangles)), (5, 4))

    def test_a_page_is_made(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, os.path.join(runs.ROOT, "scripts", "gallery"), "--only", "pyramid", "tiny_hole",
                                   "--out", folder], stdin=subprocess.DEVNULL, capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(os.path.join(folder, "index.html")) as f:
                self.assertEqual(f.read().count("<figure><img"), 4)
            self.assertTrue(os.path.exists(os.path.join(folder, "sheet.png")))
            with open(os.path.join(folder, "gallery.pdf"), "rb") as f:
                pdf = f.read()
            self.assertEqual((pdf[:5], len(re.findall(rb"/Type\s*/Page\b", pdf))), (b"%PDF-", 2))

    def test_ranks_stand_beside_those_of_the_paper(self):
        gallery = program()
        ranks = [{"ranks": 1, "seconds": 2.0, "how": "measured"}, {"ranks": 32, "seconds": 0.4, "how": "simulated"}]
        self.assertEqual(gallery.rank_cells(ranks)[1], [["1", "measured", "2.00 s", "1.00", "2,908 s", "1.0"],
                                                        ["32", "simulated", "0.40 s", "5.00", "126 s", "23.1"]])
        self.assertEqual(gallery.ranks_table(ranks).count("<td>"), 12)
        self.assertEqual((gallery.timed_ranks([{"paper": None}]), gallery.ranks_table([])), ([], ""))


if __name__ == "__main__":
    unittest.main()
