"""Where the add-on keeps what the window shows."""
import os

ICONS = os.path.normpath(os.path.join(os.path.dirname(os.path.realpath(__file__)), *[os.pardir] * 3, "Resources",
                                      "icons"))
