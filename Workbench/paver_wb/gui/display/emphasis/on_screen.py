"""What has a size in the view and none in the model."""
from pivy import coin

from paver_wb.gui.display.fields import callback, put, unpickable


class OnScreen:
    """Over the drawing, hidden by nothing, not picked. `content` gets the nodes. The camera makes no room for them: pictures
    that are seen from far away would seem to be larger than the model. Subclasses may have before_frame(state)."""

    def __init__(self):
        self.root, self.content, self.before = coin.SoAnnotation(), coin.SoSwitch(), callback(self)
        for field in (self.root.renderCaching, self.root.boundingBoxCaching, self.root.renderCulling):
            field.setValue(coin.SoSeparator.OFF)  # what is in it changes in the midst of an action, and nobody is told
        self.content.whichChild = coin.SO_SWITCH_ALL
        put(self.root, self.before, unpickable(), self.content)

    def called(self, action):
        is_measured = action.isOfType(coin.SoGetBoundingBoxAction.getClassTypeId())
        wanted = coin.SO_SWITCH_NONE if is_measured else coin.SO_SWITCH_ALL
        if self.content.whichChild.getValue() != wanted:
            quietly(self.content, lambda: setattr(self.content, "whichChild", wanted))
        if action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
            self.before_frame(action.getState())

    def before_frame(self, state):
        """Called for each frame."""


def quietly(node, change):
    """Changes a node without another frame being drawn for it."""
    node.enableNotify(False)
    change()
    node.enableNotify(True)
