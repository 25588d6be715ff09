"""Where the add-on keeps what comes with it."""
import os

RESOURCES = os.path.normpath(os.path.join(os.path.dirname(os.path.realpath(__file__)), *[os.pardir] * 3, "Resources"))
EXAMPLES, ICONS, TRANSLATIONS, PAGES, FORMS = (os.path.join(RESOURCES, name) for name in (
    "examples", "icons", "translations", "docs", "ui"))
