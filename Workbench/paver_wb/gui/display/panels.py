"""Pictures painted by Qt that lie on top of the 3D view, at a place of the view or of the model."""
import ctypes
import sys

from pivy import coin
from PySide import QtCore, QtGui

from paver_wb.gui.base.widgets import canvas
from paver_wb.gui.display.fields import callback, node, put, unpickable

MARGIN = 10  # between a panel and the rim of the view, pixels
SHEET, RIM, INK, FAINT = (255, 255, 255, 225), (0, 0, 0, 70), (25, 28, 32), (105, 110, 118)


def font(size=9, bold=False):
    made = QtGui.QFont(QtGui.QGuiApplication.font().family(), size)
    made.setBold(bold)
    return made


def text_size(text, of_font):
    metrics = QtGui.QFontMetrics(of_font)
    return metrics.boundingRect(0, 0, 4000, 4000, 0, text).size()


def sheet(width, height, margins=3 * (MARGIN,), paper=SHEET, rim=RIM):
    """(image, painter) of a rounded sheet; the painter's origin is the sheet's upper left corner. margins: at each side, above,
    below."""
    side, above, below = margins
    image, painter = canvas(width + 2 * side, height + above + below)
    painter.translate(side, above)
    painter.setPen(QtGui.QColor(*rim))
    painter.setBrush(QtGui.QColor(*paper))
    painter.drawRoundedRect(QtCore.QRectF(0.5, 0.5, width - 1, height - 1), 5, 5)
    return image, painter


def set_image(node, image):
    """Gives a SoImage the picture of a QImage; None empties it."""
    if image is None:
        node.image.setValue(coin.SbVec2s(0, 0), 0, b"")
        return
    image = image.convertToFormat(QtGui.QImage.Format_RGBA8888).mirrored(False, True)
    content = bytes(image.constBits())
    node.image.setValue(coin.SbVec2s(image.width(), image.height()), 4, content)


def image_node(image, across, up):
    """A SoImage that stands at its place by its alignments."""
    made = node(coin.SoImage, horAlignment=across, vertAlignment=up)
    set_image(made, image)
    return made


def give_ray_back(_, action):
    """A camera bends the ray of a pick to itself, and all that comes after would not be found."""
    if action.isOfType(coin.SoRayPickAction.getClassTypeId()):
        coin.cast(action, "SoRayPickAction").computeWorldSpaceRay()


def graphics():
    """The system's OpenGL; None where it is called otherwise."""
    names = {"win32": "opengl32", "darwin": "/System/Library/Frameworks/OpenGL.framework/OpenGL"}
    try:
        library = ctypes.CDLL(names.get(sys.platform, "libGL.so.1"))
        library.glIsEnabled.restype = ctypes.c_ubyte
        return library
    except (OSError, AttributeError):
        return None


class Unclipped:
    """`begin` and `end`: nodes between which FreeCAD's clipping planes do not count, which Coin cannot take back.

    stand_in(point): called with a place where Coin does not leave out what lies there, and with None afterwards.
    """

    PLANES = range(0x3000, 0x3006)  # GL_CLIP_PLANE0 on

    def __init__(self, stand_in):
        self.library, self.planes, self.is_inside, self.stand_in = graphics(), [], False, stand_in
        self.begin, self.end = callback(self), callback(self)

    def called(self, action):
        if not action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            return
        state = action.getState()
        coin.SoCacheElement.invalidate(state)  # it would keep what is switched at one time
        self.is_inside = not self.is_inside
        element = coin.SoClipPlaneElement.getInstance(state)
        if self.is_inside:
            self.planes = [plane for plane in self.PLANES if self.library is not None and self.library.glIsEnabled(plane)]
        if element.getNum():
            self.stand_in([element.get(i) for i in range(element.getNum())] if self.is_inside else None)
        for plane in self.planes:
            (self.library.glDisable if self.is_inside else self.library.glEnable)(plane)


def kept_point(point, planes, margin):
    """A point near `point` that no clipping plane takes away, by at least `margin`."""
    at = coin.SbVec3f(*point)
    for _ in range(20):
        for plane in planes:
            missing = margin - plane.getDistance(at)
            if missing > 0:
                at = at + plane.getNormal() * missing
    return at.getValue()


UPPER_MIDDLE = "Upper middle"  # of the banner
CORNERS = ("Upper left", "Upper right", "Lower left", "Lower right")
TAKEN = {"Upper right": 150, "Lower right": 70}  # pixels of width that FreeCAD's navigation cube and axes have there


def moved(image, corner, along):
    """A QImage with room so that it stands `along` pixels from the side of the view."""
    if not along:
        return image
    made, painter = canvas(image.width() + along, image.height())
    painter.drawImage(0 if corner.endswith("right") else along, 0, image)
    painter.end()
    return made


class ViewPanel:
    """A picture in a corner of the view.

    It stands inside the model, though the view shows it in the corner: so it adds nothing to the model's extent, which
    "fit all" and the camera's clipping go by.
    """

    def __init__(self, corner=CORNERS[0]):
        self.camera, self.place, self.node = coin.SoOrthographicCamera(), coin.SoTranslation(), coin.SoImage()
        self.camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
        self.root, self.switch, self.after = coin.SoAnnotation(), coin.SoSwitch(), coin.SoCallback()
        self.after.setCallback(give_ray_back, None)
        self.root.renderCulling = coin.SoSeparator.OFF  # what is clipped away would not be drawn at all
        self.unclipped = Unclipped(self.stand_between)
        put(self.switch, put(coin.SoGroup(), put(self.root, self.unclipped.begin, unpickable(), self.camera, self.place,
                                                 self.node, self.unclipped.end), self.after))
        self.corner, self.middle = corner, ((0, 0, 0), 1)
        self.stand_at(corner)

    def stand_at(self, corner):
        """One of CORNERS, or UPPER_MIDDLE."""
        self.corner = corner
        self.node.horAlignment = {"right": coin.SoImage.RIGHT, "left": coin.SoImage.LEFT}.get(corner.split()[1],
                                                                                              coin.SoImage.CENTER)
        self.node.vertAlignment = coin.SoImage.TOP if corner.startswith("Upper") else coin.SoImage.BOTTOM
        self.stand_in(*self.middle)

    def stand_in(self, centre, size):
        """Inside a model of that centre and extent."""
        self.middle = centre, size
        self.stand(centre, size)

    def stand_between(self, planes):
        """Where clipping planes leave it alone, for the frame that is being drawn; None: back in the model. Nobody is told."""
        centre, size = self.middle
        for part in (self.camera, self.place):
            part.enableNotify(False)
        self.stand(centre if planes is None else kept_point(centre, planes, 0.01 * size), size)
        for part in (self.camera, self.place):
            part.enableNotify(True)

    def stand(self, centre, size):
        half = size * 1e-3
        self.camera.position = (float(centre[0]), float(centre[1]), float(centre[2]) + half)
        self.camera.height = 2 * half
        self.camera.aspectRatio = 1
        self.camera.nearDistance, self.camera.farDistance = half * 0.5, half * 1.5
        inside = 0.9999 * half
        x = float(centre[0]) + {"right": inside, "left": -inside}.get(self.corner.split()[1], 0)
        y = float(centre[1]) + (inside if self.corner.startswith("Upper") else -inside)
        self.place.translation = (x, y, float(centre[2]))

    def show(self, image):
        """A QImage, or None to hide the panel."""
        if image is None and self.switch.whichChild.getValue() == -1:
            return  # Coin would draw another frame
        set_image(self.node, image)
        self.switch.whichChild = -1 if image is None else 0


def label(text):
    """QImage of a small sheet with a line of text."""
    size = text_size(text, font(8))
    image, painter = sheet(size.width() + 8, size.height() + 2, 3 * (3,))
    painter.setFont(font(8))
    painter.setPen(QtGui.QColor(*INK))
    painter.drawText(QtCore.QRectF(0, 0, size.width() + 8, size.height() + 2), QtCore.Qt.AlignCenter, text)
    painter.end()
    return image
