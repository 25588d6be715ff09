"""Refinements of mesh objects. Run inside FreeCAD: freecadcmd -t TestPaver."""
import json

import FreeCAD
import numpy as np

from mesh_cases import InDocument
from paver_wb import core, job, mesh_object, meshing, refinement
from paver_wb.processes import child_process


def lengths_on(result, face):
    """Of the mesh edges on a face, by its number from 0."""
    rows = result.quads[result.quad_faces == face][:, :4]
    return np.concatenate([np.linalg.norm(result.nodes[rows[:, k]] - result.nodes[rows[:, (k + 1) % 4]], axis=1)
                           for k in range(4)])


class Refinements(InDocument):
    def mesh(self, *parts, **options):
        made = mesh_object.add(self.document, list(parts) or self.box, **(options or {"size": 5}))
        self.document.recompute()
        return made

    def test_lengths_reach_the_mesh_and_the_mark_says_so(self):
        mesh = self.mesh()
        before = meshing.mesh(mesh)
        child = refinement.make(mesh, [(self.box, "Face1"), (self.box, ["Edge7", "Vertex3"])], "1 mm")
        self.assertEqual((mesh.Status, mesh.Refinements, refinement.meshes_of(child)),
                         ("Out of date", [child], [mesh]))
        result = meshing.mesh(mesh)
        self.assertEqual(mesh.Status, "Up to date")
        self.assertAlmostEqual(np.median(lengths_on(result, 0)), 1, delta=0.1)
        self.assertGreater(len(result.quads), 2 * len(before.quads))
        child.Length = 2
        self.assertEqual(mesh.Status, "Out of date")
        child.Length = 1
        self.assertEqual(mesh.Status, "Up to date", "as it was meshed")
        child.References = [(self.box, "Face2")]
        self.assertEqual(mesh.Status, "Out of date")
        self.document.removeObject(child.Name)
        self.assertEqual((mesh.Refinements, mesh.Status), ([], "Out of date"))
        self.assertEqual(meshing.mesh(mesh).report["checksum"], before.report["checksum"])

    def test_media_and_whole_solids(self):
        mesh = self.mesh(frequency="10 GHz")
        child = refinement.make(mesh, [self.box], eps_r=4)
        self.assertEqual((child.By, child.References[0][0]), (refinement.MEDIUM, self.box))
        self.assertEqual(meshing.prepare(mesh).options["local"], ["Solid1=eps-r:4.0,mu-r:1.0"])
        result = meshing.mesh(mesh)
        self.assertAlmostEqual(np.median(lengths_on(result, 0)), 1.5, delta=0.2)
        mesh.Frequency, mesh.Size = 0, 5
        with self.assertRaisesRegex(core.load().OptionError, "needs frequency"):
            meshing.mesh(mesh)

    def test_elements_of_several_objects(self):
        ball = self.add("Part::Sphere", placement=FreeCAD.Placement(FreeCAD.Vector(60, 0, 0), FreeCAD.Rotation()),
                        Radius=9)
        mesh = self.mesh(ball, self.box)
        refinement.make(mesh, [(self.box, "Face3"), (self.box, "Vertex1")], 1)
        self.assertEqual(meshing.prepare(mesh).options["local"], ["Face4,Vertex3=1.0"])
        refinement.make(mesh, [ball], 2)
        self.assertEqual(meshing.prepare(mesh).options["local"][1], "Solid1=2.0")
        result = meshing.mesh(mesh)
        self.assertAlmostEqual(np.median(lengths_on(result, 3)), 1, delta=0.1)

    def test_elements_of_what_is_inside_a_part(self):
        part = self.add("App::Part", placement=FreeCAD.Placement(FreeCAD.Vector(0, 500, 0), FreeCAD.Rotation()))
        self.add("Part::Cylinder", part, Radius=3)
        inner = self.add("Part::Box", part, FreeCAD.Placement(FreeCAD.Vector(90, 0, 0), FreeCAD.Rotation(0, 0, 30)))
        self.document.recompute()
        mesh = self.mesh(part)
        for reference in ((inner, "Face6"), (part, inner.Name + ".Face6")):
            child = refinement.make(mesh, [reference], 0.5)
            local, = meshing.prepare(mesh).options["local"]
            number = int(local.split("=")[0][len("Face"):]) - 1
            report = meshing.mesh(mesh).report["faces"][number]
            self.assertAlmostEqual(report["cad_area"], inner.Shape.Face6.Area, 6)
            self.assertGreater(report["quads"], 300)
            self.document.removeObject(child.Name)

    def test_what_the_mesh_does_not_have_is_refused(self):
        other = self.add("Part::Box")
        self.document.recompute()
        mesh = self.mesh()
        for references, says in (([(other, "Face1")], "not among"), ([(self.box, "Face7")], "does not have"),
                                 ([(self.box, "Lid")], "does not have"), ([], "refers to nothing")):
            with self.assertRaisesRegex(refinement.ReferenceMissing, says):
                refinement.make(mesh, references, 1)
        for bad in (0, -1, "two", "3 GHz", None):
            with self.assertRaisesRegex(ValueError, "length"):
                refinement.make(mesh, [(self.box, "Face1")], bad)
        self.assertEqual([thing for thing in self.document.Objects if refinement.is_refinement(thing)], [])
        child = refinement.make(mesh, ["Face1"], 1)
        self.document.removeObject(child.Name)
        refinement.make(mesh, [(self.box, "Face6")], 1)
        mesh.Part = self.add("Part::Sphere")
        self.document.recompute()
        with self.assertRaisesRegex(refinement.ReferenceMissing, "not among"):
            meshing.mesh(mesh)

    def test_saving_opening_undo_and_copies(self):
        mesh = self.mesh()
        self.document.openTransaction("Refine")
        refinement.make(mesh, [(self.box, "Face1")], 1)
        self.document.commitTransaction()
        checksum = meshing.mesh(mesh).report["checksum"]
        self.document.undo()
        self.document.undo()
        self.assertEqual((refinement.of_mesh(mesh), mesh.Status), ([], "Not meshed"))
        self.document.redo()
        self.document.redo()
        self.assertEqual((len(refinement.of_mesh(mesh)), mesh.Status), (1, "Up to date"))
        name = mesh.Name
        self.reopen()
        mesh = self.document.getObject(name)
        child, = refinement.of_mesh(mesh)
        self.assertEqual((mesh.Status, child.By, child.Length.Value), ("Up to date", "Length", 1))
        self.assertEqual(meshing.mesh(mesh).report["checksum"], checksum)
        child.Length = 3
        self.assertEqual(mesh.Status, "Out of date")

    def test_a_process_of_its_own_gets_them(self):
        mesh = self.mesh()
        mesh.Local = ["Face1=1mm"]
        refinement.make(mesh, [(self.box, "Face2")], 2)
        made = meshing.prepare(mesh)
        stored, _ = child_process.run(made, self.folder.name)
        self.assertEqual(stored.report["checksum"], meshing.mesh(mesh).report["checksum"])

    def test_the_property_local_and_jobs(self):
        mesh = self.mesh()
        mesh.Local = ["Face1=1mm"]
        refinement.make(mesh, [(self.box, "Face2")], 2)
        self.assertEqual(meshing.prepare(mesh).options["local"], ["Face1=1mm", "Face2=2.0"])
        expected = meshing.mesh(mesh).report["checksum"]
        path = self.reopen()
        FreeCAD.closeDocument(self.document.Name)
        self.document = FreeCAD.newDocument("PaverTest", hidden=True)
        code = job.main([path, "--report", path + ".json"])
        with open(path + ".json") as file:
            report = json.load(file)
        self.assertEqual((code, report["runs"][0]["report"]["checksum"]), (0, expected))
        self.assertEqual(job.main([path, "--local", "Face1=2;Edge1=0.5", "--report", path + ".json"]), 0)
        with open(path + ".json") as file:
            self.assertNotEqual(json.load(file)["runs"][0]["report"]["checksum"], expected)
