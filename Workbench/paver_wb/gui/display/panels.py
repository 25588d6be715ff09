"""Pictures painted by Qt that lie on top of the 3D view, at a place of the view or of the model."""
from pivy import coin
from PySide import QtCore, QtGui

from paver_wb.gui.display.fields import put, separator, unpickable

MARGIN = 10  # between a panel and the rim of the view, pixels
SHEET, RIM, INK, FAINT = (255, 255, 255, 225), (0, 0, 0, 70), (25, 28, 32), (105, 110, 118)


def font(size=9, bold=False):
    made = QtGui.QFont(QtGui.QGuiApplication.font().family(), size)
    made.setBold(bold)
    return made


def text_size(text, of_font):
    metrics = QtGui.QFontMetrics(of_font)
    return metrics.boundingRect(0, 0, 4000, 4000, 0, text).size()


def sheet(width, height, margin=MARGIN):
    """(image, painter) of a rounded sheet; the painter's origin is the sheet's upper left corner."""
    image = QtGui.QImage(width + 2 * margin, height + 2 * margin, QtGui.QImage.Format_RGBA8888)
    image.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(image)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.translate(margin, margin)
    painter.setPen(QtGui.QColor(*RIM))
    painter.setBrush(QtGui.QColor(*SHEET))
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


def give_ray_back(_, action):
    """A camera bends the ray of a pick to itself, and all that comes after would not be found."""
    if action.isOfType(coin.SoRayPickAction.getClassTypeId()):
        coin.cast(action, "SoRayPickAction").computeWorldSpaceRay()


class ViewPanel:
    """A picture in a corner of the view.

    It stands inside the model, though the view shows it in the corner: so it adds nothing to the model's extent, which
    "fit all" and the camera's clipping go by.
    """

    def __init__(self, right=False, top=True):
        self.camera, self.place, self.node = coin.SoOrthographicCamera(), coin.SoTranslation(), coin.SoImage()
        self.camera.viewportMapping = coin.SoCamera.LEAVE_ALONE
        self.corner = (1 if right else -1, 1 if top else -1)
        self.node.horAlignment = coin.SoImage.RIGHT if right else coin.SoImage.LEFT
        self.node.vertAlignment = coin.SoImage.TOP if top else coin.SoImage.BOTTOM
        self.root, self.switch, self.after = coin.SoAnnotation(), coin.SoSwitch(), coin.SoCallback()
        self.after.setCallback(give_ray_back, None)
        put(self.switch, put(coin.SoGroup(), put(self.root, unpickable(), self.camera, self.place, self.node),
                             self.after))
        self.stand_in((0, 0, 0), 1)

    def stand_in(self, centre, size):
        """Inside a model of that centre and extent."""
        half = size * 1e-3
        self.camera.position = (float(centre[0]), float(centre[1]), float(centre[2]) + half)
        self.camera.height = 2 * half
        self.camera.aspectRatio = 1
        self.camera.nearDistance, self.camera.farDistance = half * 0.5, half * 1.5
        inside = 0.9999
        x, y = (float(c) + s * half * inside for c, s in zip(centre, self.corner))
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
    image, painter = sheet(size.width() + 8, size.height() + 2, 3)
    painter.setFont(font(8))
    painter.setPen(QtGui.QColor(*INK))
    painter.drawText(QtCore.QRectF(0, 0, size.width() + 8, size.height() + 2), QtCore.Qt.AlignCenter, text)
    painter.end()
    return image


def label_at(point, text):
    """Node of a label at a point of the model."""
    place, node = coin.SoTranslation(), coin.SoImage()
    place.translation = tuple(float(x) for x in point)
    node.horAlignment, node.vertAlignment = coin.SoImage.LEFT, coin.SoImage.BOTTOM
    set_image(node, label(text))
    return separator(place, node)
