"""Expressions of properties: what they give is of the property's kind, and a value that is put takes their place."""
import FreeCAD

UNITS = {"App::PropertyLength": "mm", "App::PropertyDistance": "mm", "App::PropertyFrequency": "Hz", "App::PropertyAngle": "deg"}
translate = FreeCAD.Qt.translate


def of(obj):
    """{property: its expression}."""
    paths = [(path.lstrip("."), text) for path, text in obj.ExpressionEngine]  # FreeCAD 1.0 has a dot before them
    return {name: text for name, text in paths if name in obj.PropertiesList}


def unit_of(obj, name):
    """"mm", "Hz", "deg", or "" of what is a plain number."""
    return UNITS.get(obj.getTypeIdOfProperty(name), "")


def dimension(unit):
    return FreeCAD.Units.Quantity("1 " + unit).Unit


def kind_text(unit):
    """What a property of a unit takes, in a sentence."""
    return {"mm": translate("Paver", "a length"), "Hz": translate("Paver", "a frequency"), "deg": translate("Paver", "an angle")}.get(
        unit, translate("Paver", "a number without a unit"))


def check(obj):
    """ValueError where an expression gave a property a value of another kind: FreeCAD keeps 3 GHz as a length of 3e9."""
    values = {name: getattr(obj, name) for name in obj.PropertiesList if unit_of(obj, name)}
    values.update({name: evaluated(obj, text) for name, text in of(obj).items() if name not in values})
    for name, value in values.items():
        unit = unit_of(obj, name)
        if getattr(value, "Unit", dimension(unit)) != dimension(unit):
            raise ValueError(translate("Paver", "{} of '{}' is {}; give it {}, or an expression that comes to one.").format(
                name, obj.Label, value.UserString, kind_text(unit)))


def evaluated(obj, text):
    """The value of an expression; None where it has none, which FreeCAD tells."""
    try:
        return obj.evalExpression(text)
    except Exception:  # FreeCAD raises all sorts
        return None


def put(obj, name, value):
    """Sets a property. Its expression goes where that gives another value: the next recompute would bring that back."""
    expression, before, unit = of(obj).get(name), getattr(obj, name), unit_of(obj, name)
    if unit and before.Unit != dimension(unit):  # only an expression can change that, back too
        obj.setExpression(name, "1 " + unit)
        obj.recompute()
    setattr(obj, name, value)
    if name not in of(obj) or getattr(obj, name) == before:
        return
    obj.setExpression(name, None)
    if expression:
        FreeCAD.Console.PrintWarning(translate("Paver", "{} of '{}' no longer follows its expression {}: it was given another "
                                               "value.").format(name, obj.Label, expression) + "\n")
