"""What is seen of a model before it is meshed. Run inside FreeCAD: freecadcmd -t TestPaver."""
import FreeCAD
import numpy as np
import Part

from mesh_cases import InDocument
from paver_wb import core, mesh_check, mesh_object, meshing
from paver_wb.processes import fem_process, mesh_job, model_look, size_look

V = FreeCAD.Vector


class Looks(InDocument):
    def job(self, *shapes, **options):
        parts = []
        for shape in shapes:
            parts.append(self.document.addObject("Part::Feature", "Shape"))
            parts[-1].Shape = shape
        return meshing.prepare(mesh_object.add(self.document, parts, **(options or {"size": 2})))

    def model_and_shape(self, solid):
        job = self.job(solid)
        return job.model(), size_look.original(job)

    def expect_pairs_of_the_report(self, job, look):
        report = mesh_job.run(job).report
        self.assertEqual(look.pairs, len(mesh_check.touching(report)))
        return report["model"]["contacts"]

    def test_parts_that_touch_in_two_places_are_one_pair(self):
        box = Part.makeBox(10, 10, 10)
        edge_on = Part.Face(Part.makePolygon([V(x, 0, z) for x, z in ((7, 12), (9, 12), (8, 10), (7, 12))])).extrude(V(0, 10, 0))
        bridge = Part.makeBox(10, 10, 2, V(0, 0, 12)).fuse([Part.makeBox(3, 10, 2, V(0, 0, 10)), edge_on]).removeSplitter()
        job = self.job(box, bridge)
        look = model_look.look(job)
        self.assertEqual(look.pairs, 1)
        self.assertGreater(len(self.expect_pairs_of_the_report(job, look)), 1)

    def test_contacts_are_those_that_meshing_finds(self):
        upright = Part.Face(Part.makePolygon([V(5, y, z) for y, z in ((2, 10), (8, 10), (8, 18), (2, 18), (2, 10))]))
        box, cone = Part.makeBox(10, 10, 10), Part.makeCone(3, 0, 5, V(5, 5, 15), V(0, 0, -1))
        for shapes, pairs, area, edges, points in (
                ([box, Part.makeBox(4, 4, 4, V(3, 3, 10))], 1, 16, 4, 0),
                ([box, upright], 1, 0, 1, 0),
                ([box, Part.makeBox(10, 10, 10, V(20, 0, 0))], 0, 0, 0, 0),
                ([box, Part.makeBox(10, 10, 10, V(10, 0, 0)), Part.makeBox(10, 10, 10, V(20, 0, 0))], 2, 200, 8, 0),
                ([box, cone], 1, 0, 0, 1)):
            job = self.job(*shapes)
            look = model_look.look(job)
            corners = look.contact_triangles.astype(float)
            sides = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
            self.assertAlmostEqual(0.5 * np.linalg.norm(sides, axis=1).sum(), area, 4)
            self.assertEqual((look.pairs, len(look.contact_points)), (pairs, points))
            self.assertEqual(len(look.contact_lines), edges)
            self.expect_pairs_of_the_report(job, look)

    def test_small_things_are_where_merging_goes(self):
        box = Part.makeBox(10, 10, 10)
        job = self.job(box.makeFillet(0.05, box.Edges))
        look, merges = model_look.look(job), mesh_job.run(job).report["merges"]
        self.assertEqual((look.target, look.short, look.thin), (2, sum(m["kind"] == "edge" for m in merges), sum(m["kind"] == "face" for m in merges)))
        for merge in merges:
            nearest = np.linalg.norm(look.small_lines.reshape(-1, 3) - np.array(merge["where"]), axis=1).min()
            self.assertLess(nearest, 1)
        off = model_look.look(job._replace(options={**job.options, "merge": 0.001, "merge_width": 0.001}))
        self.assertEqual((off.short, off.thin, len(off.small_places)), (0, 0, 0))
        coarse = model_look.look(job._replace(options={**job.options, "size": 0.2}))
        self.assertEqual(coarse.thin, 0)

    def test_short_edges(self):
        around = [V(5 * np.cos(a), 5 * np.sin(a), 0) for a in np.linspace(0, 2 * np.pi, 301)[:-1]]
        job = self.job(Part.Face(Part.makePolygon([*around, around[0]])))
        look, merges = model_look.look(job), mesh_job.run(job).report["merges"]
        self.assertGreater(look.short, 100)
        self.assertEqual((look.short, look.thin), (len(merges), 0))
        np.testing.assert_allclose(np.linalg.norm(look.small_places, axis=1), 5, atol=0.01)

    def test_a_process_of_its_own_sees_the_same_and_tells_what_is_wrong(self):
        job = self.job(Part.makeBox(10, 10, 10), Part.makeBox(4, 4, 4, V(3, 3, 10)))
        here, there = model_look.look(job), fem_process.look(job, self.folder.name)
        for name in model_look.Look._fields:
            np.testing.assert_array_equal(getattr(here, name), getattr(there, name), name)
        with self.assertRaisesRegex(core.load().Error, "size"):
            fem_process.look(job._replace(options={}), self.folder.name)
        stop = core.load().Cancel()
        stop.set()
        with self.assertRaises(core.load().Cancelled):
            fem_process.look(job, self.folder.name, stop)

    def test_lengths_cover_the_faces_and_follow_refinements_and_bends(self):
        box, rod = Part.makeBox(40, 40, 40), Part.makeCylinder(2, 30, V(100, 0, 0))
        job = self.job(box, rod, size=8, local=["Vertex1=0.5"], max_turn=45)
        look = model_look.look(job)
        corners = look.size_triangles.astype(float)
        sides = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        self.assertAlmostEqual(0.5 * np.linalg.norm(sides, axis=1).sum() / (box.Area + rod.Area), 1, 2)
        places, lengths = corners.reshape(-1, 3), look.size_lengths.ravel()
        at = np.linalg.norm(places - np.array(tuple(job_vertex(box))), axis=1)
        self.assertAlmostEqual(lengths[at < 1e-6].min(), 0.5, 5)
        self.assertAlmostEqual(lengths[(at > 30) & (places[:, 0] < 50)].max(), 8, 5)
        is_wall = (places[:, 0] > 90) & (places[:, 2] > 5) & (places[:, 2] < 25) & (
            np.abs(np.hypot(places[:, 0] - 100, places[:, 1]) - 2) < 1e-3)
        self.assertAlmostEqual(np.median(lengths[is_wall]) / (np.pi / 4 * 2), 1, delta=0.1)
        self.assertLess(len(corners), 60000)

    def test_triangles_lie_once_over_surfaces_that_close(self):
        circles = [Part.makeCircle(radius, V(0, 0, z)) for radius, z in ((3, 0), (5, 4), (2, 9))]
        for solid in (Part.makeSphere(5), Part.makeCone(5, 0, 10), Part.makeTorus(8, 2), Part.makeCylinder(3, 10, V(), V(0, 0, 1), 200),
                      Part.makeSphere(5).toNurbs(), Part.makeLoft([Part.Wire(circle) for circle in circles], True)):
            solid.Placement = FreeCAD.Placement(V(3, 2, 1), FreeCAD.Rotation(V(1, 2, 3), 40))
            corners, _ = size_look.sizes(*self.model_and_shape(solid), {"size": 2})
            corners = corners.astype(float)
            sides = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2)
            areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
            self.assertAlmostEqual(areas.sum() / solid.Area, 1, delta=0.02)
            self.assertLess(sides.max(), 3 * solid.BoundBox.DiagonalLength / size_look.PIECES)


def job_vertex(shape):
    return shape.Vertexes[0].Point
