"""Whether a mesh fits what it was made of, and what tells so. Run inside FreeCAD: freecadcmd -t TestPaver."""
import os
from unittest import mock

import FreeCAD
import Part

from mesh_cases import InDocument
from paver_wb import export_mesh, mesh_check, mesh_object, meshing, refinement


class Meshed(InDocument):
    def mesh(self, source=None, **options):
        obj = mesh_object.add(self.document, source or self.box, **(options or {"size": 10}))
        self.document.recompute()
        meshing.mesh(obj)
        return obj

    def mesh_with_a_hole(self):
        shape = Part.makeCompound([Part.makePlane(1, 1), Part.Plane().toShape()])
        return self.mesh(self.add("Part::Feature", Shape=shape), size=0.3)


class State(Meshed):
    def test_what_has_changed_is_told(self):
        obj = self.mesh()
        self.assertEqual(mesh_object.changes(obj), [])
        obj.Size = 9
        self.assertEqual(mesh_object.changes(obj), ["Size"])
        refinement.make(obj, ["Face1"], 1)
        self.box.Length = 25
        self.document.recompute()
        self.assertEqual(mesh_object.changes(obj), ["a shape", "Size", "a refinement"])
        found = mesh_check.check(obj)[0]
        self.assertEqual((found.level, found.text), (
            mesh_check.WARNING, "The mesh is out of date (changed: a shape, Size, a refinement; mesh again)."))
        meshing.mesh(obj)
        self.assertEqual(mesh_object.changes(obj), [])
        obj.Size = 8
        self.assertEqual(mesh_object.changes(obj), ["Size"])
        obj.MeshedOptions = "not a list"
        self.assertEqual(mesh_object.changes_text(obj), "an option or a shape has changed; mesh again")

    def test_a_mesh_with_holes_is_not_simply_up_to_date(self):
        obj = self.mesh_with_a_hole()
        self.assertEqual((obj.Status, mesh_object.state_of(obj), obj.MeshStatus), (
            mesh_object.UP_TO_DATE, mesh_object.FACES_FAILED, "Faces failed"))
        obj.Size = 0.2
        self.assertEqual((mesh_object.state_of(obj), obj.MeshStatus), (mesh_object.OUT_OF_DATE, "Out of date"))

    def test_nothing_is_left_to_be_recomputed(self):
        obj = self.mesh()
        name = obj.Name
        self.assertNotIn("Touched", obj.State)
        self.document.openTransaction("Length")
        self.box.Length = 25
        self.document.recompute()
        self.document.commitTransaction()
        self.assertEqual(obj.Status, mesh_object.OUT_OF_DATE)
        for step, status in ((self.document.undo, mesh_object.UP_TO_DATE), (self.document.redo, mesh_object.OUT_OF_DATE),
                             (self.document.undo, mesh_object.UP_TO_DATE)):
            step()
            self.assertEqual((obj.Status, "Touched" in obj.State), (status, False))
            self.assertEqual(mesh_object.check(obj), status, "undo gives shapes back as copies")
            self.document.recompute()
            self.assertEqual(obj.Status, status)
        meshing.fill(obj)
        self.assertNotIn("Touched", obj.State)
        self.reopen()
        obj = self.document.getObject(name)
        self.assertEqual((obj.Status, "Touched" in obj.State), (mesh_object.UP_TO_DATE, False))
        obj.Part.Length = 25
        self.document.recompute()
        self.assertEqual(obj.Status, mesh_object.OUT_OF_DATE)

    def test_a_label_in_the_names_of_faces_is_part_of_the_mesh(self):
        other = self.add("Part::Box", placement=FreeCAD.Placement(FreeCAD.Vector(50, 0, 0), FreeCAD.Rotation()))
        self.document.recompute()
        alone, both = self.mesh(), self.mesh([self.box, other])
        self.box.Label = "Antenna"
        self.assertEqual((alone.Status, both.Status, mesh_object.changes(both)), (
            mesh_object.UP_TO_DATE, mesh_object.OUT_OF_DATE, ["a label"]))
        self.reopen()
        alone, both = mesh_object.meshes_of(self.document)
        self.assertEqual((alone.Status, both.Status), (mesh_object.UP_TO_DATE, mesh_object.OUT_OF_DATE))
        meshing.mesh(both)
        self.assertEqual((both.Status, mesh_object.changes(both)), (mesh_object.UP_TO_DATE, []))
        both.Part.Label = "Box again"
        self.assertEqual(both.Status, mesh_object.OUT_OF_DATE)
        both.Part.Label = "Antenna"
        self.assertEqual(both.Status, mesh_object.UP_TO_DATE)

    def test_nothing_moves_a_mesh_away_from_its_model(self):
        part = self.add("App::Part", placement=FreeCAD.Placement(FreeCAD.Vector(0, 30, 0), FreeCAD.Rotation()))
        part.addObject(self.box)
        obj = self.mesh()
        obj.Placement.Base.x = 30
        analysis, group = self.add_groups(part)
        for thing in (part, group, analysis):
            thing.addObject(obj)
        self.assertEqual((obj.Placement, obj.getParentGeoFeatureGroup()), (FreeCAD.Placement(), None))
        self.assertEqual((obj in analysis.Group, obj in part.Group), (True, False))
        self.assertEqual((obj.FemMesh.BoundBox.XMin, obj.FemMesh.BoundBox.YMin), (0, 30))
        self.reopen()
        obj, = mesh_object.meshes_of(self.document)
        self.assertEqual((obj.Placement, obj.getParentGeoFeatureGroup()), (FreeCAD.Placement(), None))

    def add_groups(self, part):
        """An analysis and a group inside of an App::Part."""
        made = [self.document.addObject(kind, "Group") for kind in ("Fem::FemAnalysis", "App::DocumentObjectGroup")]
        for thing in made:
            part.addObject(thing)
        return made

    def test_exports_warn_and_go_on(self):
        old, holes, good = self.mesh(), self.mesh_with_a_hole(), self.mesh(size=9)
        old.Size = 8
        path = os.path.join(self.folder.name, "mesh.msh")
        for obj, words in ((old, "is out of date (changed: Size; mesh again). It is written as it is."),
                           (holes, "has holes: Face2 could not be meshed. It is written as it is."), (good, "")):
            with mock.patch.object(FreeCAD, "Console") as console:
                self.assertEqual(export_mesh.write(obj, path), path)
            said = "".join(call.args[0] for call in console.PrintWarning.call_args_list)
            self.assertIn(words, said)
            self.assertEqual(bool(said), bool(words))


class Findings(Meshed):
    """What a check finds, and where."""

    def found(self, obj, words):
        """The only finding with these words."""
        finding, = (one for one in mesh_check.check(obj) if words in one.text)
        return finding

    def test_edges_far_shorter_than_wanted_are_found(self):
        step = 0.016
        shape = Part.makeBox(100, 100, 50).cut(Part.makeBox(50, 100, step, FreeCAD.Vector(0, 0, 50 - step)))
        obj = self.mesh(self.add("Part::Feature", Shape=shape), frequency="1 GHz")
        finding = self.found(obj, "far shorter")
        self.assertEqual(finding.level, mesh_check.WARNING)
        self.assertIn("0.016 mm instead of 30 mm", finding.text)
        mesh = mesh_object.stored(obj)
        self.assertTrue(finding.elements)
        for element in finding.elements:
            corners = mesh.nodes[mesh.quads[element - 1, :4]]
            self.assertTrue(any(abs(z - 50 + step) < 1e-9 for z in corners[:, 2]))

    def test_short_edges_that_are_wanted_are_none(self):
        cone = self.add("Part::Cone", Radius1=30, Radius2=0, Height=60)  # its tip gets short edges
        self.document.recompute()
        for source, options in ((cone, {"size": 5}), (self.box, {"size": 10, "local": ["Vertex1=0.2"]})):
            obj = self.mesh(source, **options)
            lengths = mesh_check.statistics.of_mesh(mesh_object.stored(obj)).lengths
            self.assertLess(lengths.min(), mesh_check.SHORTEST * obj.TargetLength.Value)
            self.assertEqual(self.found(obj, "No edge is shorter").level, mesh_check.GOOD)

    def test_parts_have_their_elements(self):
        other, away = (self.add("Part::Box", placement=FreeCAD.Placement(FreeCAD.Vector(x, 0, 0), FreeCAD.Rotation()))
                       for x in (10, 60))
        self.document.recompute()
        obj = self.mesh([self.box, other, away], size=5)
        mesh = mesh_object.stored(obj)
        centres = [mesh.nodes[row[:4]].mean(axis=0) for row in mesh.quads]
        apart = self.found(obj, "separate meshes").elements
        self.assertEqual(set(apart), {n for n, centre in enumerate(centres, 1) if centre[0] > 55})
        touching = self.found(obj, "touch").elements
        self.assertTrue(touching)
        self.assertTrue(all(4 < centres[n - 1][0] < 16 for n in touching))

    def test_faces_that_failed_have_their_place(self):
        bow_tie = Part.Face(Part.makePolygon([(0, 0, 0), (10, 10, 0), (10, 0, 0), (2, 9, 0), (0, 0, 0)]))
        both = Part.makeCompound([bow_tie, Part.makePlane(5, 5, FreeCAD.Vector(30, 0, 0))])
        finding = mesh_check.check(self.mesh(self.add("Part::Feature", Shape=both), size=2))[0]
        self.assertEqual((finding.level, len(finding.places)), (mesh_check.ERROR, 1))
        self.assertTrue(0 < finding.places[0][0] < 10)
        self.assertIn("Face1 is not meshed", finding.text)

    def test_a_mesh_whose_model_was_deleted_is_not_good(self):
        obj = self.mesh()
        self.document.removeObject(self.box.Name)
        self.assertEqual(mesh_check.verdict(mesh_check.check(obj)), mesh_check.WARNING)
