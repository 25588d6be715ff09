"""Shapes and documents of FreeCAD. freecad_test.py runs these cases in FreeCAD's own program and in a plain Python."""
import importlib.util
import math
import os
import sys
import tempfile
import threading
import unittest

import FreeCAD
import numpy as np
import paver
import Part

Vector, Rotation = FreeCAD.Vector, FreeCAD.Rotation


def placed(x, y, z, angle=0):
    return FreeCAD.Placement(Vector(x, y, z), Rotation(Vector(1, 2, 3), angle))


def distance(point, shape):
    return shape.distToShape(Part.Vertex(*map(float, point)))[0]


class Shapes(unittest.TestCase):
    def expect_numbers_of(self, shape, result, tolerance=1e-7):
        """Every 5th element lies on the face it names, every line on its edge, all of them."""
        self.assertEqual(result.face_names, [f"Face{i + 1}" for i in range(len(shape.Faces))])
        self.assertEqual(result.edge_names[:len(shape.Edges)], [f"Edge{i + 1}" for i in range(len(shape.Edges))])
        for rows, faces in ((result.quads, result.quad_faces), (result.triangles, result.triangle_faces)):
            for row, face in list(zip(rows, faces))[::5]:
                for node in row:
                    self.assertLess(distance(result.nodes[node], shape.Faces[face]), tolerance)
        named = list(enumerate(result.line_edges)) + [tuple(row) for row in result.further_edges]
        for line, edge in named:
            for node in result.lines[line]:
                self.assertLess(distance(result.nodes[node], shape.Edges[edge]), tolerance)
        self.assertEqual(set(result.quad_faces) | set(result.triangle_faces), set(range(len(shape.Faces))))
        return {edge for _, edge in named}

    def test_faces_and_edges_have_freecads_numbers(self):
        box, cone = Part.makeBox(10, 20, 30), Part.makeCone(4, 9, 12)
        box.Placement, cone.Placement = placed(1, 2, 3, 33), placed(40, -3, 0, 70)
        for shape in (box, cone, Part.Compound([cone, box]), box.fuse(Part.makeCylinder(5, 60)),
                      box.cut(Part.makeSphere(12)), Part.Compound([Part.makeLine((0, 0, 0), (9, 9, 99)), box])):
            result = paver.mesh(shape, size=4)
            edges = self.expect_numbers_of(shape, result)
            followed = {i for i, edge in enumerate(shape.Edges) for face in shape.Faces
                        if any(edge.isSame(other) for other in face.Edges) and edge.Length > 1e-7
                        and not edge.isSeam(face)}
            self.assertLessEqual(followed, edges)

    def test_sewn_faces_keep_the_numbers_of_the_loose_ones(self):
        loose = Part.Compound([face.copy() for face in Part.makeBox(10, 20, 30).Faces])
        self.assertEqual(len(loose.Edges), 24)
        result = paver.mesh(loose, size=4)
        self.assertTrue(result.report["quality"]["watertight"])
        self.assertEqual(self.expect_numbers_of(loose, result, 1e-4), set(range(24)))

    def test_coordinates_arrive_bit_for_bit(self):
        box = Part.makeBox(math.pi, math.e, math.sqrt(2), Vector(1 / 3, 1 / 7, 1 / 9))
        moved = box.copy()
        moved.Placement = placed(1 / 3, 1 / 7, 1 / 9, 12.345)  # the stream itself rounds rotations
        for shape, tolerance in ((box, 0), (moved, 4e-15)):
            nodes = paver.mesh(shape, size=0.5).nodes
            off = [np.abs(nodes - np.array(tuple(v.Point))).max(axis=1).min() for v in shape.Vertexes]
            self.assertLessEqual(max(off), tolerance)

    def test_every_format_is_recognised_as_bytes(self):
        shape = Part.makeBox(10, 20, 30).cut(Part.makeCylinder(3, 50))
        with tempfile.TemporaryDirectory() as folder:
            for kind, write in (("STEP", shape.exportStep), ("IGES", shape.exportIges), ("BREP", shape.exportBrep),
                                ("BREP", shape.exportBinary)):
                path = os.path.join(folder, "shape.dat")
                write(path)
                with open(path, "rb") as file:
                    content = file.read()
                for source in (content, bytearray(content), memoryview(content), path):
                    report = paver.mesh(source, size=5).report
                    self.assertEqual(report["model"]["format"], kind)
                    self.assertEqual(report["model"]["faces"], len(shape.Faces))
                    self.assertAlmostEqual(report["model"]["area"], shape.Area, 3)

    def test_quantities_count_with_their_units(self):
        units = FreeCAD.Units.Quantity
        shape = Part.makeSphere(20)
        result = paver.mesh(shape, frequency=units("9 GHz"), divisions=units("8"), max_turn=units("0.5 rad"))
        again = paver.mesh(shape, frequency="9GHz", divisions=8, max_turn=math.degrees(0.5))
        self.assertEqual(result.report["checksum"], again.report["checksum"])
        self.assertEqual(paver.mesh(shape, size=units("1 in")).report["target_length"], 25.4)
        for name, bad in (("size", "3 GHz"), ("divisions", "8 mm"), ("max_turn", "8 mm")):
            with self.assertRaisesRegex(paver.OptionError, name + " is '[38].*(GHz|mm)'"):
                paver.mesh(shape, **{**({} if name == "size" else {"frequency": "9GHz"}), name: units(bad)})

    def test_shared_faces_are_meshed_once(self):
        both, _ = Part.makeBox(10, 10, 10).generalFuse([Part.makeBox(10, 10, 10, Vector(10, 0, 0))])
        result = paver.mesh(both, size=3)
        one, two = result.parts
        self.assertEqual(len(set(one.faces) & set(two.faces)), 1)
        self.assertEqual(result.report["quality"]["border_edges"], 0)
        self.assertEqual(len(result.face_names), 11)

    def test_what_has_nothing_to_mesh_is_refused(self):
        for shape in (Part.Shape(), Part.Vertex(0, 0, 0), Part.Compound([])):
            with self.assertRaises(paver.InputError) as caught:
                paver.mesh(shape, size=1)
            self.assertEqual(caught.exception.code, "no_faces")

    def test_a_face_that_fails_has_freecads_number(self):
        shape = Part.Compound([Part.makePlane(1, 1), Part.Plane().toShape(), Part.makePlane(2, 2, Vector(5, 5, 5))])
        with self.assertRaises(paver.FaceError) as caught:
            paver.mesh(shape, size=0.3)
        self.assertEqual((caught.exception.face, caught.exception.faces), ("Face2", ("Face2",)))
        self.assertEqual(set(caught.exception.result.quad_faces), {0, 2})


class Documents(unittest.TestCase):
    def setUp(self):
        self.document = FreeCAD.newDocument()
        self.addCleanup(lambda: FreeCAD.closeDocument(self.document.Name))

    def add(self, kind, placement, inside=None, **properties):
        thing = self.document.addObject(kind, kind.split(":")[-1])
        for name, value in properties.items():
            setattr(thing, name, value)
        thing.Placement = placement
        if inside:
            inside.addObject(thing)
        return thing

    def expect_box(self, result, *placements):
        """The nodes fill boxes of 10 x 20 x 30 that stand at these placements, one after the other."""
        corners = [Vector(x, y, z) for x in (0, 10) for y in (0, 20) for z in (0, 30)]
        points = [placement.multVec(corner) for placement in placements for corner in corners]
        for point in points:
            self.assertLess(np.abs(result.nodes - np.array(tuple(point))).sum(axis=1).min(), 1e-9)
        low, high = np.array(points).min(0), np.array(points).max(0)
        np.testing.assert_allclose([result.nodes.min(0), result.nodes.max(0)], [low, high], atol=1e-9)

    def test_objects_are_taken_where_they_stand(self):
        own, inner, outer = placed(1, 2, 3, 30), placed(100, 0, 0, 45), placed(0, 1000, 0, 60)
        link = placed(0, 0, 500, 7)
        top = self.add("App::Part", outer)
        part = self.add("App::Part", inner, top)
        box = self.add("Part::Box", own, part, Length=10, Width=20, Height=30)
        far = self.add("App::Link", link, top, LinkedObject=box)
        of_part = self.add("App::Link", link, LinkedObject=part)
        self.document.recompute()
        self.expect_box(paver.mesh(box, size=5), outer.multiply(inner).multiply(own))
        self.expect_box(paver.mesh(part, size=5), outer.multiply(inner).multiply(own))
        self.expect_box(paver.mesh(far, size=5), outer.multiply(link))
        self.expect_box(paver.mesh(of_part, size=5), link.multiply(own))
        both = paver.mesh([box, far], size=5)
        self.expect_box(both, outer.multiply(inner).multiply(own), outer.multiply(link))
        self.expect_box(paver.mesh(top, size=5), outer.multiply(inner).multiply(own), outer.multiply(link))
        self.assertEqual(both.report["model"]["file"], f"{box.Label}, {far.Label}")
        self.assertEqual(paver.Model(box, name="mine").name, "mine")

    def test_link_arrays(self):
        box = self.add("Part::Box", placed(0, 0, 0), Length=10, Width=20, Height=30)
        several = self.add("App::Link", placed(0, 0, 0), LinkedObject=box, ElementCount=3)
        for i, element in enumerate(several.ElementList):
            element.Placement = placed(50 * i, 0, 0)
        self.document.recompute()
        self.expect_box(paver.mesh(several, size=10), *(placed(50 * i, 0, 0) for i in range(3)))

    @unittest.skipUnless(importlib.util.find_spec("PartDesign"), "bodies need FreeCAD's own program")
    def test_bodies(self):
        body = self.add("PartDesign::Body", placed(7, 0, 0, 20))
        block = self.add("PartDesign::AdditiveBox", placed(0, 0, 0), body, Length=10, Width=20, Height=30)
        empty = self.add("PartDesign::Body", placed(0, 0, 0))
        self.document.recompute()
        for thing in (body, block):
            self.expect_box(paver.mesh(thing, size=10), placed(7, 0, 0, 20))
        with self.assertRaisesRegex(paver.InputError, "has no shape"):
            paver.mesh(empty, size=10)

    def test_parts_name_the_faces_of_each_object(self):
        box = self.add("Part::Box", placed(0, 0, 0), Length=10, Width=20, Height=30)
        ball = self.add("Part::Sphere", placed(50, 0, 0), Radius=9)
        self.document.recompute()
        model = paver.Model([ball, box, Part.makeCone(3, 5, 7, Vector(0, -50, 0))])
        result = paver.mesh(model, size=4)
        for part, shape in zip(result.parts, (ball.Shape, box.Shape, Part.makeCone(3, 5, 7, Vector(0, -50, 0)))):
            self.assertEqual((len(part.faces), len(part.edges)), (len(shape.Faces), len(shape.Edges)))
            for number, face in zip(part.faces, shape.Faces):
                report = result.report["faces"][number]
                self.assertAlmostEqual(report["cad_area"], face.Area, 6)
                for node in result.quads[result.quad_faces == number][:3].ravel():
                    self.assertLess(distance(result.nodes[node], face), 1e-7)

    def add_antenna(self):
        """A rod on a board in an App::Part."""
        part = self.add("App::Part", placed(0, 0, 50))
        board = self.add("Part::Box", placed(0, 0, 0), part, Label="Ground plane", Length=40, Width=30, Height=2)
        rod = self.add("Part::Cylinder", FreeCAD.Placement(Vector(20, 15, 2), Rotation()), part, Label="Rod", Radius=3,
                       Height=20)
        self.document.recompute()
        return part, board, rod

    BOARD = [f"Ground plane/Face{i}" for i in range(1, 7)]
    ROD = [f"Rod/Face{i}" for i in range(1, 4)]
    ANTENNA = BOARD + ROD + ["Ground plane/Face6 + Rod/Face2"]

    def test_faces_are_called_by_the_object_they_are_of(self):
        part, board, rod = self.add_antenna()
        for ranks in (0, 2):
            result = paver.mesh(part, size=5, ranks=ranks)
            self.assertEqual(result.face_names, self.ANTENNA)
            self.assertEqual([face["label"] for face in result.report["faces"]], self.ANTENNA)
            self.assertEqual(result.report["components"], [["Ground plane", "Rod"]])
            self.assertEqual([contact["parts"] for contact in result.report["model"]["contacts"]], [["Ground plane", "Rod"]])
        self.assertEqual(paver.mesh([board, rod], size=5).face_names, self.ANTENNA)
        self.assertEqual(paver.mesh(board, size=5).face_names, [f"Face{i}" for i in range(1, 7)])
        shapes = paver.mesh([board.Shape, rod.Shape], size=5)
        self.assertEqual(shapes.report["faces"][7]["label"], "Shape2/Face2")

    def test_wires_and_points_are_called_by_their_object_too(self):
        board = self.add("Part::Box", placed(0, 0, 0), Label="Board", Length=40, Width=30, Height=2)
        wire, feed = (self.add("Part::Feature", FreeCAD.Placement(), Label=label) for label in ("Monopole", "Feed"))
        wire.Shape = Part.makeLine(Vector(20, 15, 2), Vector(20, 15, 30))
        feed.Shape = Part.Vertex(Vector(10, 15, 2))
        self.document.recompute()
        for ranks in (0, 2):
            result = paver.mesh([board, wire, feed], size=5, ranks=ranks)
            self.assertEqual(result.report["components"], [["Board", "Monopole", "Feed"]])
            self.assertEqual(set(result.edge_groups), {"", "Monopole"})
            self.assertEqual(result.point_names, ["Feed"])
            np.testing.assert_allclose(result.nodes[result.points], [(10, 15, 2)], atol=1e-9)

    def test_a_wire_alone_has_a_mesh_file(self):
        for ending, ranks in (("msh", 0), ("vtu", 2)):
            with tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "wire." + ending)
                result = paver.mesh(Part.makeLine(Vector(0, 0, 0), Vector(0, 0, 30)), size=5, output=path, ranks=ranks)
                self.assertEqual((len(result.quads) + len(result.triangles), len(result.lines)), (0, 6))
                self.assertTrue(os.path.exists(path))

    def test_hidden_members_of_a_part_are_left_out_and_those_of_parts_inside_are_not(self):
        part, board, rod = self.add_antenna()
        inner = self.add("App::Part", placed(0, 0, 0), part)
        self.add("Part::Box", placed(100, 0, 0), inner, Label="Load")
        self.add("Part::Box", placed(200, 0, 0), part, Label="Hidden").Visibility = False
        link = self.add("App::Link", FreeCAD.Placement(Vector(0, 0, 500), Rotation()), LinkedObject=part, Label="Copy")
        self.document.recompute()
        load = [f"Load/Face{i}" for i in range(1, 7)]
        self.assertEqual(paver.mesh(part, size=5).face_names, self.BOARD + self.ROD + load + self.ANTENNA[-1:])
        names = paver.mesh([part, link], size=5).face_names
        self.assertEqual(names[0], "Part/Ground plane/Face1")
        self.assertEqual(names[15 + 9], "Copy/Part001/Load/Face1")

    @unittest.skipUnless(importlib.util.find_spec("Import"), "exporting STEP needs FreeCAD's own program")
    def test_objects_of_a_step_file_keep_their_names(self):
        import Import
        part, board, rod = self.add_antenna()
        link = self.add("App::Link", placed(0, 0, 500, 7), LinkedObject=rod)
        self.document.recompute()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "antenna.step")
            Import.export([part, link], path)
            result = paver.mesh(path, size=5)
            Import.export([board], path)
            self.assertEqual(paver.mesh(path, size=5).face_names[0], "Face1")
        self.assertEqual(result.face_names, self.BOARD + [f"Rod:1/Face{i}" for i in (1, 2, 3)] +
                         [f"Rod:2/Face{i}" for i in (1, 2, 3)] + ["Ground plane/Face6 + Rod:1/Face2"])
        self.assertEqual(result.report["components"], [["Ground plane", "Rod:1"], ["Rod:2"]])

    def test_a_model_is_meshed_in_another_thread(self):
        box = self.add("Part::Box", placed(1, 2, 3, 30), Length=10, Width=20, Height=30)
        self.document.recompute()
        model, results = paver.Model(box), []
        thread = threading.Thread(target=lambda: results.append(paver.mesh(model, size=5, progress=lambda *_: None)))
        thread.start()
        box.Placement = placed(99, 99, 99)  # the model was taken before
        thread.join()
        self.expect_box(results[0], placed(1, 2, 3, 30))


def run():
    """Exit code."""
    suite = unittest.defaultTestLoader.loadTestsFromModule(sys.modules[__name__])
    outcome = unittest.TextTestRunner(stream=sys.stdout, verbosity=1).run(suite)
    return 0 if outcome.wasSuccessful() and outcome.testsRun > 5 else 1
