"""Texts of the property editor. Documents keep them in English; FreeCAD translates what it shows, in the context
"App::Property". scripts/translations collects them from the calls of tip() and from the core's table of options. Names of
properties stay those of scripts, as in all of FreeCAD."""


def tip(text):
    """Marks a tooltip or the name of a group."""
    return text


def counted(count, one, many):
    """The sentence that fits a count."""
    return one if count == 1 else many


def listed(names, most, between=", "):
    """The first names, so many at most."""
    return between.join(names[:most]) + (" \u2026" if names[most:] else "")


def has_default(info):
    return info["default"] != ""


def tooltip(info):
    """Of an option, by its entry of the core's table."""
    text = info["help"]
    if has_default(info):
        return f"{text} [{info['default']}]"
    if info["kind"] == "local":
        return text + ". Besides those of the refinements"
    if info["kind"] == "named":
        return text + ". Besides those that are objects of their own"
    return text + (". Negative: automatic" if info["may_be_zero"] else ". 0: not given")
