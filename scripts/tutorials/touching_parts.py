"""Parts of metal that touch: contacts, a port, junctions."""
import math

TITLE = "Parts that touch"
ABOUT = "A satellite of sheets and solids for 300 MHz: contacts seen before meshing, parts connected without fusing them, a port, junctions."
MODEL = "gallery/satellite.step"
FOOT = (25, 660)  # mm: radius and height of the circle where the feed's horn stands on its rod


def circles(thing, radius, height):
    """Names of the edges: two parts have one each."""
    return [f"Edge{number}" for number, edge in enumerate(thing.Shape.Edges, 1)
            if abs(edge.Length - 2 * math.pi * radius) < 0.1 and abs(edge.CenterOfMass.z - height) < 0.1]


def walk(it):
    it.step("Open the model", f"Choose the workbench **Paver** and {it.open('satellite.step')}; {it.look()} and "
            f"{it.command('Std_ViewFitAll')} show it from a corner.",
            f"Unfold {it.unfold('Satellite')} in the tree: its nine parts touch, but are not fused.")
    it.step("Create a mesh", f"Click on {it.select('Satellite')} and choose {it.command('Paver_CreateMesh')}: all parts are meshed together.",
            f"Click {it.press('Frequency')} and write {it.write('Frequency', '300 MHz')}, which comes to about {it.predicts()} elements.")
    it.step("How parts are connected", f"Open {it.press('More options')}: **Parts that touch** is on *{it.chosen('Parts that touch')}*, so that "
            f"they share edges and nodes where they touch, and every face stays.", "With *union* only the outer skin would be left.")
    it.step("See the contacts", f"Close {it.press('More options')} again and tick {it.press('Preview')}.",
            f"The panel says: *{it.previews()}*. Contacts are blue in the 3D view, over the colours of the target length.")
    foot = circles(it.thing("Satellite"), *FOOT)
    it.step("Name a port", f"Press {it.press('OK')}, look from the front with {it.look('Std_ViewFront')}, click on the horn ({it.select('Solid005')}) "
            f"and choose {it.command('Std_ViewFitSelection')} to see it large; click on the circle between horn and rod{it.clicks('Satellite', *foot)}, and choose "
            f"{it.command('Paver_Port')}.", f"Write the name {it.write('Name', 'Feed')}{it.snap()} and press {it.press('OK')}.")
    it.step("Mesh", f"Choose {it.look()} and {it.command('Std_ViewFitAll')}, double-click on {it.double_click('PaverMesh')} in the tree, untick "
            f"{it.press('Preview')}, which would cover the mesh, and press {it.press('Mesh')}.", f"The mesh has {it.meshed()} elements. The row *Contacts* of the result says *{it.figure('Contacts')}*: all parts hang "
            "together.")
    it.step("Walk through the findings", f"Press {it.press('Details')} beside the verdict, and click on *{it.finding('parts touch')}*.",
            "The elements where parts meet get rings, and are selected.")
    it.step("See the junctions", f"Click on *{it.finding('more than two elements')}*, and {it.press('Next')} to see one of these from near. "
            f"{it.press('Close')} that, press {it.press('OK')} and choose {it.command('Paver_ShowFreeEdges')}.",
            "Junctions, where more than two elements meet at an edge, are violet; free edges, as those of the panels, are red.")
    it.step("Export", f"Choose {it.export('satellite.msh')}, write a name and press **Save**.",
            f"The file has a group for each face, and the group **{it.group('satellite.msh', 'Feed')}** for the edges of the port.")
