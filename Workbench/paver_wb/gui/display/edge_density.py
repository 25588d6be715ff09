"""Element edges in their full colour, fainter, or not at all, by the pixels that an element has in the view.

Coin's own node for that, SoLevelOfDetail, asks every action for what only drawing has: a click in FreeCAD's view, which is
an action of FreeCAD's, ends the program.
"""
from pivy import coin

from paver_wb.gui.display.fields import callback, put

DARK, FAINT, NONE = 0, 1, -1  # children of the switch
FULL_COLOUR, ANY_COLOUR = 120, 20  # pixels of area that a mean element has at least


class EdgeDensity:
    """`nodes` draw the edges of a mesh, as large as set_mesh() says, into whichever view they are shown in."""

    def __init__(self, dark, faint):
        """dark, faint: the nodes to draw for edges of the full colour, and for faint ones."""
        self.low, self.high, self.area = (0.0,) * 3, (0.0,) * 3, 0.0
        self.switch = coin.SoSwitch()
        put(self.switch, dark, faint)
        self.switch.whichChild = DARK
        self.nodes = callback(self), self.switch

    def set_mesh(self, low, high, area):
        """low, high: the corners of the box around the mesh; area: mean of its elements, mm^2; 0: always draw all."""
        self.low, self.high, self.area = tuple(map(float, low)), tuple(map(float, high)), float(area)

    def called(self, action):
        if action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            state = action.getState()
            coin.SoCacheElement.invalidate(state)  # what is drawn depends on the camera
            self.choose(DARK if self.area <= 0 else density(self.area * pixels_per_length(state, self.low, self.high) ** 2))

    def choose(self, child):
        """The switch tells nobody: it changes in the midst of the frame that it is for."""
        if self.switch.whichChild.getValue() != child:
            self.switch.enableNotify(False)
            self.switch.whichChild = child
            self.switch.enableNotify(True)


def density(pixels):
    """pixels: of a mean element."""
    return DARK if pixels >= FULL_COLOUR else FAINT if pixels >= ANY_COLOUR else NONE


def pixels_per_length(state, low, high):
    """At the point of a box that is nearest to the eye."""
    volume, window = coin.SoViewVolumeElement.get(state), coin.SoViewportRegionElement.get(state)
    to_world = coin.SoModelMatrixElement.get(state)
    eye = to_world.inverse().multVecMatrix(volume.getProjectionPoint()).getValue()
    nearest = coin.SbVec3f(*(min(max(e, a), b) for e, a, b in zip(eye, low, high)))
    width = volume.getWorldToScreenScale(to_world.multVecMatrix(nearest), 1)  # of the whole view at that distance
    return window.getViewportSizePixels()[0] / width if width > 0 else float("inf")
