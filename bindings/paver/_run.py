"""mesh(), predict() and their options, which come from the core's table."""
import inspect
import numbers
from typing import NamedTuple

from . import _paver
from ._errors import FaceError, OptionError
from ._jobs import poll_of, printed
from ._model import as_model
from ._result import Result, file_arguments

UNITS = {"length": "mm", "frequency": "Hz", "angle": "deg"}  # in which FreeCAD quantities are passed on


class Prediction(NamedTuple):
    """What a run will come to.

    target_length: mm.
    elements: about how many, all faces together. core/docs/prediction.md says how near it comes.
    memory_mib: what meshing takes at most on top of what the process has, MiB.
    face_elements: (faces,) float64, elements by face; 0 for faces that will not be meshed.
    merges: [dict] of what will be merged, as it is small: `kind` ("edge", "face"), `name`, `into`, `size` (mm), `where`.
    contacts: [dict] of where parts touch: `parts`, `kind`, `size` (mm^2, mm or a number), `gap` (mm).
    """

    target_length: float
    elements: float
    memory_mib: float
    face_elements: object
    merges: list
    contacts: list


def text_of_quantity(kind, value):
    """As a plain number in the core's unit; as FreeCAD shows it, for the core to refuse, when it is of another kind."""
    if kind in UNITS:
        try:
            return repr(float(value.getValueAs(UNITS[kind])))
        except (ValueError, TypeError):
            return value.UserString
    return value.UserString if any(value.Unit.Signature) else repr(float(value.Value))


def text_of(name, kind, value):
    """The text of an option's value, which the core reads as it reads the command line."""
    value = value.item() if hasattr(value, "item") else value  # of a number of NumPy
    if isinstance(value, str):
        return value
    if kind == "flag" and isinstance(value, bool):
        return "on" if value else "off"
    if hasattr(value, "getValueAs"):  # FreeCAD.Units.Quantity
        return text_of_quantity(kind, value)
    if isinstance(value, numbers.Integral) and not isinstance(value, bool):
        return str(int(value))
    if isinstance(value, numbers.Real) and not isinstance(value, bool):
        return repr(float(value))
    raise OptionError(f"{name} is {value!r}; write a number, or text with a unit.", "bad_option",
                      "write a number, or text with a unit")


def local_text(name, parts, length):
    """Text of the length of parts."""
    if hasattr(length, "items"):  # a medium
        length = ",".join(f"{what}:{text_of(name, 'number', number)}" for what, number in length.items())
    try:
        names = parts if isinstance(parts, str) else ",".join(parts)
    except TypeError:
        raise OptionError(f'{name} has {parts!r}; name parts, like "Face3".', "bad_option", "name parts") from None
    return f"{names}={text_of(name, 'length', length)}"


def named_text(name, own, parts):
    """Text of parts under a name of their own."""
    facts = {}
    if hasattr(parts, "items"):
        facts = {fact: said for fact, said in parts.items() if fact != "parts"}
        parts = parts.get("parts", ())
    listed = [parts] if isinstance(parts, str) else list(parts)
    for fact, said in facts.items():
        if isinstance(said, bool):
            listed += [fact] if said else []
        else:
            listed.append(f"{fact}:{text_of(name, 'length' if fact == 'radius' else 'number', said)}")
    return f"{own}={','.join(listed)}"


REPEATED = {"local": local_text, "named": named_text}  # kinds, and what gives the text of an entry of a dict


def repeated_texts(name, kind, value):
    """Texts of an option of one of the kinds REPEATED, which may be a dict, one text or several."""
    if isinstance(value, str):
        return [value]
    if not hasattr(value, "items"):
        return [text_of(name, kind, text) for text in value]
    return [REPEATED[kind](name, key, said) for key, said in value.items()]


def given_options(options):
    kinds = {info["name"]: info["kind"] for info in _paver.options()}
    given = []
    for name, value in options.items():
        if value is None:
            continue
        kind = kinds.get(name)
        texts = repeated_texts(name, kind, value) if kind in REPEATED else [text_of(name, kind, value)]
        given += [(name, text) for text in texts]
    return given


def require_faces(result, is_partial):
    try:
        result._data.check()
    except FaceError as error:
        error.faces, error.result = tuple(result.failed_faces), result
        if not is_partial:
            raise


def mesh(shape, *, output=None, report=None, repaired=None, msh_version="4.1", ascii=False, quiet=True, partial=False, progress=None,
         cancel=None, name=None, **options):
    """Meshes `shape` and gives a Result. Arguments are those of the command line, by the same names.

    shape: a Model, or what Model takes: a Part.Shape, an object of a FreeCAD document, a list of these, a path, bytes.
    output, report, msh_version, ascii: files to write, as Result.write does; checked before the work.
    repaired: file (.brep) for the model as it is meshed: repaired, sewn, connected.
    quiet: False prints the stages and the report's table.
    partial: True gives the mesh of the other faces where some cannot be meshed; else FaceError, which has it too.
    progress: called before the work and then up to 20 times a second as progress(stage, fraction), in the calling
        thread; ("done", 1.0) at the end. Giving False stops the run with Cancelled; an exception stops it and goes on.
    cancel: a Cancel (or threading.Event): stops the run with Cancelled when set, by whatever thread.
    name: of the model in messages and in the report.

    Other threads run on while it works, and Ctrl-C ends it. Raises OptionError, InputError, LimitError, OutputError,
    FaceError, Cancelled, OutOfMemory, InternalError; all are Error.
    """
    given = given_options(options)
    model = as_model(shape, name)
    _paver.check_outputs(file_arguments(model, output, report, msh_version, ascii, repaired))
    poll = poll_of(progress if quiet else printed(progress), cancel)
    brep = b"" if repaired is None else _paver.repaired(model._source, given, poll)
    result = Result(_paver.mesh(model._source, given, poll), model)
    if any(path is not None for path in (output, report, repaired)):
        is_empty = len(result.quads) + len(result.triangles) + result.report["quality"]["wire_lines"] == 0
        files = file_arguments(model, None if is_empty else output, report, msh_version, ascii, repaired, brep)
        result._write(files, None, cancel)
    if not quiet:
        print(result.table, end="")
    require_faces(result, partial)
    return result


def predict(shape, *, progress=None, cancel=None, name=None, **options):
    """About how many elements, and how much memory, mesh() with the same arguments will come to; a Prediction.

    Costs a small part of meshing: the model is read (once, when `shape` is a Model), areas and curvatures are sampled.
    `max_elements` is no limit here. Errors as in mesh().
    """
    given = given_options(options)
    return Prediction(**_paver.predict(as_model(shape, name)._source, given, poll_of(progress, cancel)))


def target_lengths(shape, faces, uv, points, *, progress=None, cancel=None, name=None, **options):
    """(n,) float64: target length, mm, that mesh() with the same options has at points of faces: how short elements get
    there, across the strongest turn of the surface. 0 on faces that will not be meshed.

    faces: (n,) numbers from 0; uv: (n, 2) parameters on their surfaces; points: (n, 3), mm. Costs what predict() does, with
    its errors.
    """
    import numpy as np
    arrays = (np.ascontiguousarray(faces, "i4"), np.ascontiguousarray(uv, "f8"), np.ascontiguousarray(points, "f8"))
    return _paver.target_lengths(as_model(shape, name)._source, given_options(options), *arrays,
                                 poll_of(progress, cancel))


def options():
    """The options of mesh() and predict(), in order.

    Dicts with `name`, `kind` (length, frequency, angle, number, integer, choice, flag, local, named), `letter` (stands for the value in
    help texts), `help`, `default` (text, maybe empty), `needs`, `excludes` (another option's name, or empty), `choices`,
    `may_be_zero` (without a default: 0 is a value of its own, which a form must not use for "none").
    """
    return _paver.options()


def describe(function):
    """Gives a function the options of the table as arguments and in its help."""
    signature = inspect.signature(function)
    own = [p for p in signature.parameters.values() if p.kind is not inspect.Parameter.VAR_KEYWORD]
    first = [p for p in own if p.kind is not inspect.Parameter.KEYWORD_ONLY]
    table = _paver.options()
    added = [inspect.Parameter(info["name"], inspect.Parameter.KEYWORD_ONLY, default=None) for info in table]
    function.__signature__ = signature.replace(parameters=first + added + own[len(first):])
    lines = [f"    {i['name']} ({i['kind']}): {i['help']}" + (f" [{i['default']}]" if i["default"] else "")
             for i in table]
    notes = ('Options, as numbers (mm, Hz, degrees), text with a unit ("30 mm", "9 GHz") or FreeCAD quantities; local '
             'as {"Face3": "2 mm", ("Edge5", "Vertex2"): 0.5, "Solid1": {"eps_r": 4}}; medium as {"FR4": {"parts": "Solid1", '
             '"eps_r": 4.4, "tan_d": 0.02}, "Metal": {"parts": ["Solid2"], "conductor": True}}, port as {"Feed": '
             '["Edge5"]}, wire as {"Mast": {"parts": ["Edge7"], "radius": 0.5}}:')
    function.__doc__ = "\n".join([inspect.cleandoc(function.__doc__), "", notes, *lines])


for described in (mesh, predict, target_lengths):
    describe(described)
