"""What is clicked in Bodies, links, groups and arrays, and where it is meshed. Run inside FreeCAD: freecadcmd -t TestPaver."""
import FreeCAD

from mesh_cases import InDocument
from paver_wb import mesh_object, meshing, refinement
from paver_wb.children import named_parts, references


def at(x):
    return FreeCAD.Placement(FreeCAD.Vector(x, 0, 0), FreeCAD.Rotation())


class Places(InDocument):
    def link(self, thing, x, **values):
        return self.add("App::Link", LinkedObject=thing, placement=at(x), **values)

    def body(self, inside=None):
        """(Body, its feature)."""
        body = self.add("PartDesign::Body", inside)
        feature = body.newObject("PartDesign::AdditiveBox", "Block")
        self.document.recompute()
        return body, feature

    def mesh(self, *things):
        obj = mesh_object.add(self.document, list(things), size=10)
        self.document.recompute()
        return obj, meshing.mesh(obj)

    def port_at(self, obj, thing, path):
        """Where, along x, a port lies of what a click gives, and the labels of its faces."""
        named_parts.make_port(obj, [(thing, references.without_features(thing, path))])
        result = meshing.mesh(obj)
        faces = [i for i, group in enumerate(result.face_groups) if group]
        x = result.nodes[result.quads[[face in faces for face in result.quad_faces]]][..., 0]
        return x.min(), x.max(), [result.report["faces"][i].get("label") for i in faces]

    def test_the_innermost_object_is_meant_that_stands_where_it_is_seen(self):
        part = self.add("App::Part", placement=at(5))
        part.addObject(self.box)
        outer = self.add("App::Part")
        outer.addObject(part)
        group = self.document.addObject("App::DocumentObjectGroup", "Group")
        other = self.add("Part::Box")
        group.addObject(other)
        links = self.add("App::LinkGroup", ElementList=[self.add("Part::Box")], placement=at(40))
        link, array = self.link(part, 60), self.link(other, 80, ElementCount=2)
        plain = self.link(other, 120, ShowElement=False, ElementCount=2)
        body, feature = self.body(outer)
        sketch = body.newObject("Sketcher::SketchObject", "Sketch")
        self.document.recompute()
        for top, path, thing, rest in (
                (self.box, "Face1", self.box, "Face1"), (outer, f"{part.Name}.Box.Face1", self.box, "Face1"),
                (outer, f"{part.Name}.", part, ""), (group, f"{other.Name}.Face1", other, "Face1"),
                (links, f"{links.ElementList[0].Name}.Face1", links, f"{links.ElementList[0].Name}.Face1"),
                (link, "Box.Face1", link, "Box.Face1"), (array, "1.Face1", array.ElementList[1], "Face1"),
                (plain, "1.Face1", plain, "1.Face1"),
                (outer, f"{body.Name}.{feature.Name}.Face1", body, f"{feature.Name}.Face1"),
                (outer, f"{body.Name}.{sketch.Name}.Edge1", sketch, "Edge1")):
            self.assertEqual(references.standing(top, path), (thing, rest), path)

    def test_it_is_meshed_there_with_labels(self):
        part = self.add("App::Part")
        part.addObject(self.box)
        part.addObject(self.add("Part::Box", placement=at(20)))
        outer = self.add("App::Part", placement=at(100))
        link, group = self.link(part, 60), self.add("App::LinkGroup", ElementList=[self.add("Part::Box")], placement=at(40))
        array, plain = self.link(self.box, 200, ElementCount=2), self.link(self.box, 0, ShowElement=False, ElementCount=2)
        for thing in (array, plain):
            outer.addObject(thing)
        plain.PlacementList = [at(0), at(50)]
        array.ElementList[1].Placement = at(30)
        self.document.recompute()
        for things, first, last, labels in (
                ([link], 60, 90, {"Box", "Box001"}), ([group], 40, 50, {None}), ([array.ElementList[1]], 330, 340, {None}),
                ([plain], 100, 160, {f"{plain.Label}_i0", f"{plain.Label}_i1"}),
                ([array], 300, 340, {element.Label for element in array.ElementList}),
                ([link, part], 0, 90, {f"{thing.Label}/{name}" for thing in (link, part) for name in ("Box", "Box001")})):
            _, result = self.mesh(*things)
            self.assertEqual((result.nodes[:, 0].min(), result.nodes[:, 0].max()), (first, last), things[0].Label)
            found = {face["label"].rpartition("/")[0] if "/" in face.get("label", "") else None
                     for face in result.report["faces"]}
            self.assertEqual(found, labels, things[0].Label)

    def test_what_refers_to_an_instance_means_that_one(self):
        part, outer = self.add("App::Part"), self.add("App::Part", placement=at(1000))
        part.addObject(self.box)
        links = [self.link(part, x) for x in (30, 60)]
        array = self.link(self.box, 0, ShowElement=False, ElementCount=2, PlacementList=[at(100), at(200)])
        for thing in (*links, array):
            outer.addObject(thing)
        self.document.recompute()
        obj, _ = self.mesh(outer)
        for (top, path), x in (((outer, f"{links[1].Name}.Box.Face2"), 1070), ((outer, f"{array.Name}.1.Face1"), 1200)):
            least, most, _ = self.port_at(obj, *references.standing(top, path))
            self.assertEqual((least, most), (x, x), path)
            self.document.removeObject(obj.Ports[0].Name)
        for thing, path in ((links[1], "Box.Face9"), (self.link(part, 90), "Box.Face1")):
            self.assertRaises(references.ReferenceMissing, refinement.make, obj, [(thing, path)], 1)

    def test_a_solid_in_a_link_is_made_of_something(self):
        part = self.add("App::Part")
        for thing in (self.box, self.add("Part::Box", placement=at(20))):
            part.addObject(thing)
        link = self.link(part, 100)
        self.document.recompute()
        obj, _ = self.mesh(link)
        medium = named_parts.make_medium(obj, [(link, ["Box.Face1", "Box.Face2"])], eps_r=4)
        self.assertEqual(medium.References, [(link, ("Box.",))])
        for _ in range(2):
            self.assertEqual(named_parts.option_texts(obj, [obj.Part])["medium"], ["Medium=Solid1,eps-r:4.0,mu-r:1.0,tan-d:0.0"])
            self.reopen()
            obj, = mesh_object.meshes_of(self.document)

    def test_elements_of_a_body_stay_when_features_follow(self):
        body, feature = self.body()
        body.Placement = at(20)
        obj, _ = self.mesh(body)
        # A face that the chamfer does not touch: FreeCAD 1.0 gives up references to those that it cuts.
        thing, path = references.standing(body, f"{feature.Name}.Face2")
        child = refinement.make(obj, [(thing, references.without_features(thing, path))], 1)
        self.assertEqual(child.References, [(body, ("Face2",))])
        self.assertEqual(references.without_features(body, feature.Name + "."), "")
        old, _ = self.mesh(feature)  # as documents of before Bodies were meant have it
        self.assertTrue(refinement.make(old, [(body, "Face1")], 1))
        chamfer = body.newObject("PartDesign::Chamfer", "Chamfer")
        chamfer.Base, chamfer.Size = (feature, ["Edge1"]), 1
        self.document.recompute()
        self.assertGreater(len(meshing.mesh(obj).quads), 50)
        linked = self.link(body, 50)
        self.document.recompute()
        self.assertEqual(references.without_features(linked, f"{chamfer.Name}.Face1"), "Face1")
