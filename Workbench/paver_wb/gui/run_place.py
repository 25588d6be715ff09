"""The face or edge that an error names, selected in the 3D view."""
import FreeCADGui

from paver_wb import mesh_object, meshing


def counts(source, path):
    """{"Face": number, "Edge": number} of what lies at a path of sub-objects."""
    import Part
    shape = Part.getShape(source, path, needSubElement=False)
    return {"Face": len(shape.Faces), "Edge": len(shape.Edges)}


def sub_name(source, element):
    """"Box.Face3" for "Face9" of an App::Part, "Face3" for a thing that has faces of its own."""
    kind, path = element[:4], ""
    number = int(element[4:])
    while not source.getSubObject(f"{path}{kind}{number}"):
        for child in source.getSubObjects() if not path else source.getSubObject(path, 1).getSubObjects():
            count = counts(source, path + child)[kind]
            if number <= count:
                path += child
                break
            number -= count
        else:
            return ""  # the shape itself; something is selected then
    return f"{path}{kind}{number}"


def show(obj, mesh):
    """Shows a mesh object, or else its sources, and hides the other: drawn at the same place they make spots."""
    sources = [source for source in mesh_object.sources(obj) if not mesh or meshing.may_be_hidden(source)]
    for thing, is_shown in [(obj, mesh)] + [(source, not mesh) for source in sources]:
        if thing.ViewObject.Visibility != is_shown:
            thing.ViewObject.Visibility = is_shown


def select(obj, place):
    """Selects a mesh_job.Place of a mesh object's sources, alone, and shows the source if it is hidden.

    False when the sources have no such place any more.
    """
    sources = mesh_object.sources(obj)
    if place is None or place.source >= len(sources):
        return False
    source = sources[place.source]
    FreeCADGui.Selection.clearSelection()
    if not source.ViewObject.Visibility:
        source.ViewObject.Visibility = True
    FreeCADGui.Selection.addSelection(source, sub_name(source, place.element))
    return True
