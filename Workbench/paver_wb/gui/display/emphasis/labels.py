"""Short texts at points of the model, never hidden by it, nor by each other: those that would overlap stand above each other,
each with a line to its point."""
import numpy as np
from pivy import coin

from paver_wb.gui.display.emphasis.on_screen import OnScreen, quietly
from paver_wb.gui.display.fields import colour_node, fill, line_style, own_indices, put, separator, unlit
from paver_wb.gui.display.panels import image_node, label

MOST_LABELS = 20
OFFSET, GAP = 10, 1  # pixels: from the point to the lower left corner of its label; between labels
LINE = (0.12, 0.13, 0.15)


class Labels(OnScreen):
    """`texts`: those that are shown; `corners`: (labels, 2) where their lower left corners lie in the frame drawn last."""

    def __init__(self):
        super().__init__()
        self.texts, self.points, self.sizes, self.corners = [], np.zeros((0, 3)), np.zeros((0, 2)), np.zeros((0, 2))
        self.places, self.ends, self.lines = [], coin.SoCoordinate3(), coin.SoIndexedLineSet()

    def show(self, points, texts):
        if not self.texts and not len(texts):
            return
        self.content.removeAllChildren()
        self.texts = list(texts)[:MOST_LABELS]
        self.points = np.asarray(points, float).reshape(-1, 3)[:MOST_LABELS]
        images = [label(text) for text in self.texts]
        self.sizes = np.array([(image.width(), image.height()) for image in images], float).reshape(-1, 2)
        self.places = [coin.SoTranslation() for _ in images]
        fill(self.lines.coordIndex, np.zeros(0, np.int32))
        self.put_at(self.points)
        fill(self.lines.coordIndex, own_indices((len(images), 2)))
        put(self.content, separator(unlit(), colour_node(LINE), line_style(1), self.ends, self.lines))
        for place, image in zip(self.places, images):
            put(self.content, separator(place, image_node(image, coin.SoImage.LEFT, coin.SoImage.BOTTOM)))

    def put_at(self, places):
        """Labels at these points of the model."""
        for at, place in zip(self.places, places):
            quietly(at, lambda at=at, place=place: at.translation.setValue(*(float(x) for x in place)))
        ends = np.stack([self.points, places], axis=1).reshape(-1, 3)
        quietly(self.ends, lambda: fill(self.ends.point, ends))

    def before_frame(self, state):
        """Places for the camera of this frame."""
        if not self.texts:
            return
        volume = coin.SoViewVolumeElement.get(state)
        size = np.array(coin.SoViewportRegionElement.get(state).getViewportSizePixels().getValue(), float)
        to_screen = as_array(coin.SoModelMatrixElement.get(state)) @ as_array(volume.getMatrix())
        seen = through(to_screen, self.points)
        self.corners = apart((seen[:, :2] + 1) / 2 * size + OFFSET, self.sizes, size)
        seen[:, :2] = self.corners / size * 2 - 1
        self.put_at(through(np.linalg.inv(to_screen), seen))


def as_array(matrix):
    """(4, 4) of a SbMatrix, for rows of coordinates."""
    return np.array(matrix.getValue(), float).reshape(4, 4)


def through(matrix, points):
    """(n, 3) points as a matrix moves them."""
    moved = np.column_stack([points, np.ones(len(points))]) @ matrix
    return moved[:, :3] / moved[:, 3:]


def apart(corners, sizes, view):
    """(labels, 2) corners that are moved up until no labels overlap, first ones first; those that would leave the view at
    the right are moved to the left."""
    made = np.array(corners, float)
    inside = (made > -view).all(axis=1) & (made < 2 * view).all(axis=1)
    made[inside, 0] = np.minimum(made[inside, 0], np.maximum(view[0] - sizes[inside, 0], 0))
    for i, (width, height) in enumerate(sizes):
        moved = True
        while moved:
            moved = False
            for (x, y), (w, h) in zip(made[:i], sizes[:i]):
                overlap = x < made[i, 0] + width and made[i, 0] < x + w and y < made[i, 1] + height and made[i, 1] < y + h
                if overlap:
                    made[i, 1], moved = y + h + GAP, True
    return made
