"""Where the add-on keeps what the window shows."""
import os

RESOURCES = os.path.normpath(os.path.join(os.path.dirname(os.path.realpath(__file__)), *[os.pardir] * 3, "Resources"))
ICONS, TRANSLATIONS, PAGES, FORMS = (os.path.join(RESOURCES, name) for name in ("icons", "translations", "docs", "ui"))
