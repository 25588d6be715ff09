"""Expressions of and on mesh objects. Run inside FreeCAD: freecadcmd -t TestPaver."""
from mesh_cases import InDocument
from paver_wb import mesh_object, meshing, properties, refinement
from paver_wb.children import named_parts


class Expressions(InDocument):
    def setUp(self):
        super().setUp()
        self.sheet = self.add_sheet(length="=2 mm", frequency="=3 GHz", mass="=5 kg", number="=4")

    def add_sheet(self, **cells):
        sheet = self.document.addObject("Spreadsheet::Sheet", "Sheet")
        for row, (name, content) in enumerate(cells.items(), 1):
            sheet.set(f"A{row}", content)
            sheet.setAlias(f"A{row}", name)
        self.document.recompute()
        return sheet

    def bound(self, name, text, **options):
        obj = mesh_object.add(self.document, self.box, **(options or {"size": 5}))
        self.bind(obj, name, text)
        return obj

    def bind(self, obj, name, text):
        obj.setExpression(name, text)
        self.document.recompute()

    def test_values_of_another_kind_are_refused_in_a_sentence(self):
        for name, text, said in (("Size", "Sheet.frequency", "3.00 GHz; give it a length"), ("Size", "Sheet.mass", "a length"),
                                 ("Frequency", "Sheet.length", "give it a frequency"),
                                 ("Divisions", "Sheet.length", "give it a number without a unit")):
            obj = self.bound(name, text, **({"size": 5} if name == "Size" else {"frequency": "30 GHz"}))
            with self.assertRaisesRegex(ValueError, f"^{name} of '{obj.Label}' is .*{said}.*\\.$"):
                meshing.mesh(obj)
        obj = self.bound("Size", "Sheet.number")
        self.assertGreater(len(meshing.mesh(obj).quads), 0)
        for child, name in ((refinement.make(obj, ["Face1"], 1), "Length"),
                            (named_parts.make_wire(obj, [(self.box, "Edge1")]), "Radius")):
            self.bind(child, name, "Sheet.mass")
            with self.assertRaisesRegex(ValueError, f"^{name} of '{child.Label}'"):
                meshing.mesh(obj)
            self.document.removeObject(child.Name)

    def test_a_value_that_is_put_takes_the_place_of_an_expression(self):
        obj = self.bound("Size", "Sheet.length")
        properties.put(obj, {"size": 2, "order": 1})
        self.assertTrue(obj.ExpressionEngine, "the same value changes nothing")
        properties.put(obj, {"size": "5 mm"})
        self.assertEqual((obj.Size.Value, obj.ExpressionEngine), (5, []))
        self.sheet.touch()
        self.document.recompute()
        self.assertEqual(obj.Size.Value, 5)
        self.bind(obj, "Size", "Sheet.length")
        properties.put(obj, {"frequency": "30 GHz"})
        self.document.recompute()
        self.assertEqual((obj.Size.Value, obj.ExpressionEngine), (0, []))
        child = refinement.make(obj, ["Face1"], 1)
        self.bind(child, "Length", "Sheet.length")
        refinement.set_value(child, 3)
        self.document.recompute()
        self.assertEqual(child.Length.Value, 3)

    def test_a_value_is_put_over_one_of_another_kind(self):
        obj = self.bound("Size", "Sheet.frequency")
        properties.put(obj, {"size": "5 mm"})
        self.assertEqual((obj.Size.UserString, obj.ExpressionEngine), ("5.00 mm", []))
        self.assertGreater(len(meshing.mesh(obj).quads), 0)

    def test_expressions_read_the_results_of_now(self):
        obj = mesh_object.add(self.document, self.box, size=10)
        reader, sheet = self.add("Part::Box"), self.add_sheet(quads=f"={obj.Name}.Quads")
        self.bind(reader, "Length", f"{obj.Name}.Quads * 1 mm")
        for size in (10, 5):
            obj.Size = size
            meshing.mesh(obj)
            self.document.recompute()
            self.assertEqual((reader.Length.Value, sheet.quads, "Touched" in obj.State), (obj.Quads, obj.Quads, False))
        self.document.undo()
        self.document.recompute()
        self.assertEqual((reader.Length.Value, sheet.quads), (obj.Quads, obj.Quads))
