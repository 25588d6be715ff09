"""Media, ports and wires of mesh objects. Run inside FreeCAD: freecadcmd -t TestPaver."""
import os
import tempfile

import FreeCAD
import Part

from mesh_cases import InDocument
from paver_wb import core, export_mesh, import_mesh, mesh_check, mesh_object, meshing, refinement
from paver_wb.children import named_parts
from paver_wb.formats import mesh_file


def physical_names(path):
    """{(dimension, name)} of a .msh file written as text."""
    with open(path, encoding="utf-8") as file:
        lines = file.read().partition("$PhysicalNames\n")[2].partition("$EndPhysicalNames")[0].splitlines()[1:]
    return {(int(line.split()[0]), line.split('"')[1]) for line in lines}


def volumes(path):
    """[signed surfaces] of the volumes of a .msh 4.1 file written as text."""
    with open(path, encoding="utf-8") as file:
        lines = file.read().partition("$Entities\n")[2].partition("$EndEntities")[0].splitlines()
    count = int(lines[0].split()[3])
    return [[int(side) for side in line.split()[10:]] for line in lines[len(lines) - count:]] if count else []


class Named(InDocument):
    def labelled(self, kind, label, **values):
        thing = self.add(kind, **values)
        thing.Label = label
        return thing

    def antenna(self):
        """A conducting plate with a wire on it, on a board, and its mesh object."""
        plate = self.labelled("Part::Box", "Plate", Length=60, Width=60, Height=1)
        board = self.labelled("Part::Box", "Board", placement=FreeCAD.Placement(FreeCAD.Vector(0, 0, -3), FreeCAD.Rotation()),
                         Length=60, Width=60, Height=3)
        mast = self.document.addObject("Part::Feature", "Mast")
        mast.Shape = Part.makeLine(FreeCAD.Vector(20, 20, 1), FreeCAD.Vector(20, 20, 31))
        self.document.recompute()
        plate.Label = "Ground plane"
        mesh = mesh_object.add(self.document, [plate, board], frequency="3 GHz")
        self.document.recompute()
        return mesh, plate, board, mast

    def test_names_reach_the_mesh_its_files_and_the_report(self):
        mesh, plate, board, mast = self.antenna()
        named_parts.make_medium(mesh, [(board, "Face1")], eps_r=4.4, tan_d=0.02, name="FR4")
        named_parts.make_medium(mesh, [plate], conductor=True, name="Metal")
        named_parts.make_port(mesh, [(plate, ["Edge1"]), (plate, "Vertex1")], name="Feed, left")
        named_parts.make_port(mesh, [(plate, "Face1")], name="Load")
        named_parts.make_wire(mesh, [mast], "0.5 mm", name="Whip")
        self.assertEqual(mesh.MoreParts, [board, mast], "the wire is meshed, too")
        result = meshing.mesh(mesh)
        self.assertEqual(mesh.Status, "Up to date")
        report = result.report
        self.assertEqual(report["verdict"], "sound", report["faults"])
        self.assertEqual([medium["name"] for medium in report["media"]], ["FR4", "Metal"])
        self.assertEqual(report["wires"], [{"name": "Whip", "parts": report["wires"][0]["parts"], "radius": 0.5}])
        sides = {(face["front_medium"], face["back_medium"]) for face in report["faces"] if face["quads"]}
        self.assertEqual(sides, {("", "Metal"), ("", "FR4"), ("Metal", "FR4")} if ("Metal", "FR4") in sides else
                         {("", "Metal"), ("", "FR4"), ("FR4", "Metal")})
        self.assertIn("Whip", mesh_file.wires(mesh_object.stored(mesh)))
        self.assertNotIn("Feed, left", mesh_file.wires(mesh_object.stored(mesh)))
        self.assertGreater(mesh.Lines, 2)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "mesh.msh")
            export_mesh.write(mesh, path, ascii=True)
            names = physical_names(path)
            for wanted in ((2, "Load"), (1, "Feed, left"), (0, "Feed, left"), (1, "Whip"), (1, "Junctions"), (3, "FR4"),
                           (3, "Metal"), (2, "Ground plane/Face2")):
                self.assertIn(wanted, names)
            solids = volumes(path)
            self.assertEqual(len(solids), 2)
            shared, = set(map(abs, solids[0])) & set(map(abs, solids[1]))
            self.assertNotEqual(shared in solids[0], shared in solids[1], "the common face looks out of one, into the other")
            again = import_mesh.add(self.document, path)
            self.assertEqual(again.Quads, mesh.Quads)

    def test_a_name_in_files_may_be_the_label_of_another_object(self):
        mesh, plate, board, _ = self.antenna()
        medium = named_parts.make_medium(mesh, [board])
        for name, label, in_files in (("Board", "Board001", "Board"), ("FR4", "Board001", "FR4"), ("Board001", "Board001", ""),
                                      ("Core", "Core", "")):
            named_parts.change(medium, [board], label=name)
            self.assertEqual((named_parts.name_of(medium), medium.Label, medium.NameInFiles), (name, label, in_files))
            self.assertTrue(named_parts.option_texts(mesh, [plate, board])["medium"][0].startswith(name + "="))

    def test_groups_of_ports_and_wires_in_freecads_mesh(self):
        mesh, plate, board, mast = self.antenna()
        named_parts.make_port(mesh, [(plate, ["Face1", "Edge1", "Vertex1"])], name="Feed")
        named_parts.make_wire(mesh, [mast], 0.5, name="Whip")
        meshing.mesh(mesh)
        meshing.fill(mesh)
        fem = mesh.FemMesh
        kinds = {(fem.getGroupName(i), fem.getGroupElementType(i)) for i in fem.Groups}
        for wanted in (("Feed", "Face"), ("Feed", "Edge"), ("Feed", "Node"), ("Whip", "Edge"), ("Junctions", "Edge")):
            self.assertIn(wanted, kinds)

    def test_a_medium_sets_the_target_length_unless_it_conducts(self):
        mesh = mesh_object.add(self.document, self.box, frequency="10 GHz")
        self.document.recompute()
        coarse = meshing.mesh(mesh)
        medium = named_parts.make_medium(mesh, [self.box], eps_r=4)
        self.assertEqual(mesh.Status, "Out of date")
        fine = meshing.mesh(mesh)
        self.assertGreater(len(fine.quads), 2.5 * len(coarse.quads))
        medium.Conductor = True
        self.assertEqual(len(meshing.mesh(mesh).quads), len(coarse.quads))
        medium.Label = "Metal"
        self.assertEqual(mesh.Status, "Out of date", "files have the name")
        self.assertEqual(mesh_object.changes(mesh), ["a medium, port or wire"])
        meshing.mesh(mesh)
        refinement.make(mesh, ["Face1"], 1)
        self.assertEqual(mesh_object.changes(mesh), ["a refinement"])

    def test_ports_are_not_merged_with_others(self):
        box, rounded = self.add("Part::Box", Length=20, Width=20, Height=20), self.document.addObject("Part::Fillet", "Step")
        rounded.Base, rounded.Edges = box, [(edge, 0.2, 0.2) for edge in range(1, 13)]
        self.document.recompute()
        mesh = mesh_object.add(self.document, rounded, size=8)
        self.document.recompute()
        merged = {merge["name"] for merge in meshing.mesh(mesh).report["merges"]}
        self.assertTrue(merged)
        name = min(merged)
        named_parts.make_port(mesh, [(rounded, name)], name="Slit")
        result = meshing.mesh(mesh)
        self.assertNotIn(name, [merge["name"] for merge in result.report["merges"]])
        self.assertEqual(result.report["verdict"], "sound")

    def test_children_are_saved_and_go_with_undo_and_their_object(self):
        mesh, plate, board, mast = self.antenna()
        made = [named_parts.make_medium(mesh, [board], eps_r=2.2, name="PTFE"),
                named_parts.make_port(mesh, [(plate, "Edge1")]), named_parts.make_wire(mesh, [mast])]
        self.assertEqual(named_parts.of_mesh(mesh), made)
        before = named_parts.option_texts(mesh, mesh_object.sources(mesh))
        labels = [child.Label for child in made]
        self.document.removeObject(made.pop(0).Name)
        self.assertEqual((mesh.Media, named_parts.of_mesh(mesh)), ([], made))
        self.document.openTransaction("Medium")
        named_parts.make_medium(mesh, [board], eps_r=2.2, name="PTFE")
        self.document.commitTransaction()
        self.document.undo()
        self.assertEqual(mesh.Media, [])
        self.document.redo()
        self.assertEqual(named_parts.option_texts(mesh, mesh_object.sources(mesh)), before)
        name = mesh.Name
        self.reopen()
        again = self.document.getObject(name)
        self.assertEqual(named_parts.option_texts(again, mesh_object.sources(again)), before)
        self.assertEqual([child.Label for child in named_parts.of_mesh(again)], labels)

    def test_faults_are_one_sentence_and_leave_nothing(self):
        mesh, plate, board, mast = self.antenna()
        ball = self.labelled("Part::Sphere", "Ball")
        before = [obj.Name for obj in self.document.Objects]
        for call, text in (
                (lambda: named_parts.make_medium(mesh, [board], eps_r=0), "EpsR of 'Medium' is 0"),
                (lambda: named_parts.make_medium(mesh, [board], tan_d=-1), "LossTangent of"),
                (lambda: named_parts.make_medium(mesh, [mast], eps_r=2), "not among the objects"),
                (lambda: named_parts.make_medium(mesh, [ball], eps_r=2), "not among the objects"),
                (lambda: named_parts.make_port(mesh, [(plate, "Face99")]), "Face99"),
                (lambda: named_parts.make_wire(mesh, [(plate, "Face1")]), "cannot be in a wire"),
                (lambda: named_parts.make_wire(mesh, [mast], radius=-2), "Radius of"),
                (lambda: named_parts.make_port(mesh, []), "refers to nothing")):
            with self.assertRaisesRegex(ValueError, text):
                call()
            self.assertEqual([obj.Name for obj in self.document.Objects], before)
            self.assertEqual(mesh.MoreParts, [board])
        named_parts.make_port(mesh, [(plate, "Edge1")], name="A")
        named_parts.make_port(mesh, [(plate, "Edge1")], name="B")
        with self.assertRaisesRegex(core.load().OptionError, "'B' names Edge1, which 'A' has already"):
            meshing.mesh(mesh)

    def test_what_is_lost_of_a_port_is_a_fault(self):
        plate, block = self.labelled("Part::Box", "Plate", Length=40, Width=40, Height=5), self.labelled("Part::Box", "Block", placement=FreeCAD.Placement(FreeCAD.Vector(0, 0, 5), FreeCAD.Rotation()), Length=40,
            Width=40, Height=5)
        mesh = mesh_object.add(self.document, [plate, block], size=10, connect="union")
        self.document.recompute()
        named_parts.make_port(mesh, [(plate, "Face6")], name="Inside")
        with self.assertRaisesRegex(core.load().FaceError, "Not in the mesh: Face6 of 'Inside'"):
            core.load().mesh(mesh_object.sources(mesh), **meshing.options_of(mesh, {}))
        meshing.mesh(mesh)
        finding = mesh_check.check(mesh)[0]
        self.assertEqual((finding.level, "Face6 of 'Inside'" in finding.text), (mesh_check.ERROR, True))

    def test_materials_of_freecad(self):
        found = named_parts.materials(self.document)
        self.assertTrue(named_parts.values_of_material(found["Copper-Generic"])["Conductor"])
        self.assertEqual(named_parts.values_of_material(found["Water"])["EpsR"], 80)
        self.assertNotIn("Concrete-Generic", list(found))
        with self.assertRaisesRegex(ValueError, "type the values"):
            named_parts.values_of_material({"Name": "Cheese"})

    def test_refinements_and_media_stand_side_by_side(self):
        mesh, plate, board, _ = self.antenna()
        refinement.make(mesh, [(plate, "Face1")], 2)
        named_parts.make_medium(mesh, [board], eps_r=3)
        options = meshing.options_of(mesh, {})
        self.assertEqual((len(options["local"]), options["medium"]), (1, ["Medium=Solid2,eps-r:3.0,mu-r:1.0,tan-d:0.0"]))
