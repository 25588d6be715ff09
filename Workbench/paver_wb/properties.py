"""The options of a run as properties of a document object. The core's table of options is the only list of them."""
import FreeCAD

from paver_wb import core
from paver_wb.base import expressions
from paver_wb.base.proxies import add_property
from paver_wb.base.texts import has_default, tip, tooltip

GROUP = tip("Mesh options")
TYPES = {"length": "App::PropertyLength", "frequency": "App::PropertyFrequency", "angle": "App::PropertyAngle",
         "number": "App::PropertyFloat", "integer": "App::PropertyInteger", "choice": "App::PropertyEnumeration",
         "flag": "App::PropertyBool", "local": "App::PropertyStringList", "named": "App::PropertyStringList"}
REPEATED = ("local", "named")  # kinds of which a list of texts is given
RANKS = "ranks"
WITHOUT_EFFECT = {"threads", "max_elements", "strict", RANKS}  # on a mesh that was made


def property_name(option):
    """"MaxTurn" of "max_turn"."""
    return "".join(word.capitalize() for word in option.split("_"))


def type_of(info):
    """Where 0 is a value of its own, "none" is a negative one, which a PropertyLength cannot hold."""
    return "App::PropertyDistance" if info["may_be_zero"] and info["kind"] == "length" else TYPES[info["kind"]]


def initial(info):
    if info["kind"] in REPEATED:
        return []
    if not has_default(info):
        return -1 if info["may_be_zero"] else 0
    if info["kind"] == "flag":
        return info["default"] == "on"
    return {"integer": int, "choice": str}.get(info["kind"], float)(info["default"])


def add_to(obj):
    """Adds the properties that `obj` does not have yet, all of a new object, some of one of an older file.

    CoreMissing when the core, which has the table, cannot be loaded.
    """
    for info in core.load().options():
        values = [info["choices"], initial(info)] if info["kind"] == "choice" else [initial(info)]
        add_property(obj, type_of(info), property_name(info["name"]), GROUP, tooltip(info), *values)


def has_ranks():
    """Whether the core can mesh with several processes."""
    return any(info["name"] == RANKS for info in core.load().options())


def check_ranks(obj):
    """ValueError when a mesh object asks for several processes and the core cannot do that."""
    if obj.Ranks != 0 and not has_ranks():
        raise ValueError(f"'{obj.Label}' asks for {obj.Ranks} MPI ranks, which this build of Paver does not have; set its "
                         "property Ranks to 0.")


def is_option(obj, name):
    return name in obj.PropertiesList and obj.getGroupOfProperty(name) == GROUP


def value_of(obj, info):
    """Number in the core's unit (mm, Hz, degrees, which are FreeCAD's own) or text; None: not given."""
    value = getattr(obj, property_name(info["name"]))
    value = getattr(value, "Value", value)
    if has_default(info):
        return value
    if info["kind"] in REPEATED:
        return list(value) or None
    return None if (value < 0 if info["may_be_zero"] else value == 0) else value


def needed(values):
    """{option: value} without those that are None and those that need an option that is."""
    return {info["name"]: values[info["name"]] for info in core.load().options()
            if values[info["name"]] is not None and (not info["needs"] or values[info["needs"]] is not None)}


def given(obj):
    """{option: value} as paver.mesh takes them, without refinements. What needs an option that is not given is left out.
    """
    return needed({info["name"]: value_of(obj, info) for info in core.load().options()})


def merged(obj, changes):
    """given() as it would be after put(obj, changes). ValueError as there."""
    table = table_for(changes)
    values = {name: value_of(obj, info) for name, info in table.items()}
    values.update({name: None for name in excluded(table, changes)})
    values.update({name: plain(table[name], value) for name, value in changes.items()})
    return needed(values)


def plain(info, value):
    """A value that put takes, as value_of gives it back."""
    if value is None:
        return initial(info) if has_default(info) else None
    if info["kind"] in REPEATED:
        return texts_of(info, value) or None
    if info["kind"] == "flag":
        if value not in (True, False, "on", "off"):
            raise ValueError(f"{info['name']} is {value!r}; it is: {info['help']}.")
        return value in (True, "on")
    if info["kind"] in ("number", "integer", "choice"):
        cast = {"integer": int, "number": float, "choice": str}[info["kind"]]
        return cast(number_of(info["name"], info["kind"], value) if isinstance(value, str) and cast != str else value)
    try:
        return float(FreeCAD.Units.Quantity(value).Value if isinstance(value, str) else getattr(value, "Value", value))
    except (ValueError, ArithmeticError):
        raise ValueError(f"{info['name']} is {value!r}; it is: {info['help']}.") from None


def text_of(options):
    """Text that is equal for equal options, as far as they have an effect on the mesh."""
    return repr(sorted((n, v) for n, v in options.items() if n not in WITHOUT_EFFECT))


def texts_of(info, value):
    """What is said of parts, as paver.mesh takes it, as a list of text."""
    core.load()
    from paver import _run
    return _run.repeated_texts(info["name"], info["kind"], value)


def put(obj, options):
    """Sets properties from {option: value}, values as paver.mesh takes them: numbers, text with a unit, quantities.
    None means not given. What excludes one of them, as a frequency does a size, is reset unless it is among them too.

    ValueError, in one sentence, for a value that the property cannot have or an option that is not there.
    """
    table = table_for(options)
    for name, value in options.items():
        if table[name]["kind"] in ("number", "integer") and isinstance(value, str):
            value = number_of(name, table[name]["kind"], value)
        if table[name]["kind"] == "flag":
            value = plain(table[name], value)
        if table[name]["kind"] in REPEATED:
            value = None if value is None else texts_of(table[name], value)
        try:
            expressions.put(obj, property_name(name), initial(table[name]) if value is None else value)
        except Exception:  # FreeCAD raises all sorts, with texts for programmers
            raise ValueError(f"{name} of '{obj.Label}' cannot be {value!r}; it is: "
                             f"{table[name]['help']}.") from None
    for name in excluded(table, options):
        expressions.put(obj, property_name(name), initial(table[name]))


def table_for(options):
    """{option: its entry of the core's table}. ValueError when one of `options` is not in it."""
    table = {info["name"]: info for info in core.load().options()}
    for name in options:
        if name not in table:
            raise ValueError(f"{name} is no option of a mesh; there are {', '.join(table)}.")
    return table


def excluded(table, options):
    """Options that are reset by putting `options`: what these exclude, unless it is among them too."""
    pairs = [(info["name"], info["excludes"]) for info in table.values() if info["excludes"]]
    return [other for pair in pairs for one, other in (pair, pair[::-1])
            if options.get(one) is not None and other not in options]


def number_of(name, kind, text):
    try:
        number = float(text)
        return number if kind == "number" else int(number) if number == int(number) else int(text)
    except (ValueError, OverflowError):
        what = "a number" if kind == "number" else "a whole number"
        raise ValueError(f"{name} is '{text}'; write {what}.") from None
