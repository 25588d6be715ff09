"""The element under the mouse, by a search tree of the core: Coin's own picking takes half a second for a million
triangles, and FreeCAD picks at every move of the mouse."""
from pivy import coin

from paver_wb.gui.display.fields import callback
from paver_wb.gui.display.report import element_name


class Picker:
    """`node` takes part in FreeCAD's picking like a shape would."""

    def __init__(self, hits):
        """hits(origin, direction): [(element, point)], nearest first; a function that holds nothing."""
        self.hits, self.node = hits, callback(self)

    def called(self, action):
        if not action.isOfType(coin.SoRayPickAction.getClassTypeId()):
            return
        ray = coin.cast(action, "SoRayPickAction")
        ray.setObjectSpace()
        line = ray.getLine()
        for element, point in self.hits(line.getPosition().getValue(), line.getDirection().getValue()):
            at = coin.SbVec3f(*point)
            if ray.isBetweenPlanes(at):
                self.add(ray, at, element)
                return

    def add(self, ray, at, element):
        picked = ray.addIntersection(at)
        if picked:
            detail = coin.SoFaceDetail()
            detail.setFaceIndex(element)
            detail.thisown = False  # Coin deletes it
            picked.setDetail(detail, self.node)

    def element_picked(self, picked):
        """"Elem17" of a SoPickedPoint. NotImplementedError, which FreeCAD understands, when it is on something else, such
        as FEM's own drawing."""
        detail = picked.getDetail(self.node)
        if not detail:
            raise NotImplementedError
        return element_name(coin.cast(detail, "SoFaceDetail").getFaceIndex())
