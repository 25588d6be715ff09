"""Series: meshes of one mesh object for several frequencies, elements per wavelength or target lengths, and a table of what
came of each. Its steps are mesh objects of their own, or files only.

Documents name this module and SeriesProxy: neither may be moved.
"""
import csv
import json
import math
import os
import tempfile
import time
from typing import NamedTuple

import FreeCAD

from paver_wb import analysis, core, export_mesh, mesh_check, mesh_object, meshing, properties, refinement, statistics
from paver_wb.base import proxies, source_shapes, units
from paver_wb.base.texts import tip
from paver_wb.children import named_parts
from paver_wb.processes import child_process, mesh_job

translate = FreeCAD.Qt.translate
GROUP = tip("Series")
FREQUENCY, DIVISIONS, SIZE = VARIED = ("frequency", "divisions", "size")
ARGUMENTS = {FREQUENCY: "frequencies", DIVISIONS: "divisions", SIZE: "sizes"}  # of add()
FORMATS = ("msh", "vtu", "unv", "inp", "med")  # that are offered
MOST_STEPS = 200
LOGARITHMIC = "log"
SPREADS = ("", LOGARITHMIC)
COLUMNS = ("value", "elements", "unknowns", "matrix_bytes", "seconds", "least_sj", "verdict", "reason", "error", "files")
MESHES, ROWS, SAVED_SHAPE = "Meshes", "Rows", "SavedShape"

# name: (type, tooltip)
PROPERTIES = {
    "Mesh": ("App::PropertyLinkGlobal", tip("The mesh object whose options, refinements and objects all steps have")),
    MESHES: ("App::PropertyLinkListGlobal", tip("A mesh object for each step; none where the meshes are files only")),
    "Varied": ("App::PropertyString", tip("The option that differs: frequency, divisions (elements per wavelength), size")),
    "Values": ("App::PropertyFloatList", tip("Its value at each step: Hz, elements per wavelength, mm")),
    "Formats": ("App::PropertyStringList", tip("Endings of the files that are written for each step")),
    "Folder": ("App::PropertyString", tip("Where the files are written")),
    "MeshNames": ("App::PropertyStringList", tip("Names of the mesh objects, one for each step")),
    ROWS: ("App::PropertyStringList", tip("What came of each step, as JSON; empty where nothing has yet")),
    SAVED_SHAPE: ("App::PropertyString", tip("Digest of the shape when the document was saved")),
}
HIDDEN = ("MeshNames", ROWS, SAVED_SHAPE)


class Step(NamedTuple):
    """One mesh of a series. number: from 0; option: one of VARIED; value: Hz, elements per wavelength or mm."""

    number: int
    option: str
    value: float

    @property
    def text(self):
        """"2.4 GHz", for people."""
        return {DIVISIONS: "{} / λ", SIZE: "{} mm"}.get(self.option, "{}").format(self.plain)

    @property
    def plain(self):
        return units.quantity_text("frequency", self.value) if self.option == FREQUENCY else units.number_text(self.value)

    @property
    def file_text(self):
        """"2.4GHz", for names of files."""
        return {DIVISIONS: "divisions{}", SIZE: "size{}mm"}.get(self.option, "{}").format(self.plain.replace(" ", ""))

    @property
    def changes(self):
        return {self.option: self.value}


class Row(NamedTuple):
    """What came of a step. unknowns: statistics.unknowns() of basis order 1; matrix_bytes: of their full matrix; verdict:
    a level of mesh_check, and the sentence for it, `reason`; error: a sentence, where there is no mesh or no file. shape,
    options: digests of what it was made of; empty in documents of before these were kept."""

    elements: int = 0
    unknowns: int = 0
    matrix_bytes: int = 0
    seconds: float = 0.0
    least_sj: float = 0.0
    verdict: str = mesh_check.ERROR
    reason: str = ""
    error: str = ""
    files: tuple = ()
    shape: str = ""
    options: str = ""

    @property
    def is_meshed(self):
        return bool(self.reason)


class Done(NamedTuple):
    """A step that has ended. mesh: the StoredMesh or None; error: the exception or None."""

    step: Step
    row: Row
    mesh: object
    error: object


class SeriesProxy(proxies.Proxy):
    Type = proxies.SERIES

    @staticmethod
    def add_properties(obj):
        for name, (kind, tooltip) in PROPERTIES.items():
            proxies.add_property(obj, kind, name, GROUP, tooltip)
            obj.setEditorMode(name, ["Hidden"] if name in HIDDEN else ["ReadOnly"])
        obj.setPropertyStatus(SAVED_SHAPE, "Output")  # else saving would leave it to be recomputed

    def onDocumentRestored(self, obj):
        """Files of FreeCAD keep shapes with 15 digits: the one that was saved is taken for the one that comes."""
        super().onDocumentRestored(obj)
        if obj.Mesh and obj.SavedShape and not core.problem():
            obj.Proxy.reopened = (obj.SavedShape, mesh_object.shape_digest(obj.Mesh))


class Observer:
    """Keeps what shape a document was saved with."""

    def slotStartSaveDocument(self, document, _path):
        for obj in of_document(document) if not core.problem() else ():
            obj.SavedShape = mesh_object.shape_digest(obj.Mesh) if obj.Mesh else ""


FreeCAD.addDocumentObserver(Observer())


# Values

def number_of(option, value):
    """Hz, elements per wavelength or mm of a number, a text with a unit or a quantity. ValueError, in one sentence."""
    unit = {FREQUENCY: "1 Hz", SIZE: "1 mm"}.get(option)
    try:
        quantity = FreeCAD.Units.Quantity(value) if isinstance(value, str) else value
        if hasattr(quantity, "Unit") and quantity.Unit not in (FreeCAD.Units.Unit(), FreeCAD.Units.Quantity(unit or "1").Unit):
            raise ValueError
        number = float(getattr(quantity, "Value", quantity))
    except (ValueError, TypeError, ArithmeticError, SyntaxError):
        number = math.nan
    if not 0 < number < math.inf:
        such = {FREQUENCY: '"2.4 GHz"', DIVISIONS: "8", SIZE: '"2 mm"'}[option]
        raise ValueError(translate("Paver", "The {} {} of a series cannot be read; write a value above 0, such as {}.").format(
            option_text(option), repr(value), such))
    return number


def option_text(option):
    """One of VARIED in a sentence."""
    return {FREQUENCY: translate("Paver", "frequency"), DIVISIONS: translate("Paver", "divisions"),
            SIZE: translate("Paver", "size")}[option]


def spread(first, last, count, how=""):
    """`count` values from first to last, evenly or, with "log", by equal factors. ValueError."""
    if not 2 <= count <= MOST_STEPS or not 0 < first < last or how not in SPREADS:
        raise ValueError(translate("Paver", "A range of a series goes from a value to a larger one in 2 to {} steps, such as "
                                   "1GHz:4GHz:7 or 1GHz:4GHz:7:log.").format(MOST_STEPS))
    shares = [i / (count - 1) for i in range(count)]
    inner = [first * (last / first) ** s if how == LOGARITHMIC else first + (last - first) * s for s in shares[1:-1]]
    return [first, *(float(f"{value:.7g}") for value in inner), last]


def values_of(option, values):
    """Rising numbers, each once, of a list, or of a text like "1 GHz, 2 GHz" or "1GHz:4GHz:7:log". ValueError."""
    entries = [part for part in values.replace(";", ",").split(",") if part.strip()] if isinstance(values, str) else list(values)
    numbers = []
    for entry in entries:
        parts = entry.split(":") if isinstance(entry, str) else [entry]
        if len(parts) in (3, 4):
            count = parts[2].strip()
            numbers += spread(number_of(option, parts[0]), number_of(option, parts[1]),
                              int(count) if count.isdigit() else 0, "".join(parts[3:]).strip())
        else:
            numbers.append(number_of(option, entry))
    if not 0 < len(set(numbers)) <= MOST_STEPS:
        raise ValueError(translate("Paver", "A series has 1 to {} values of {}, not {}.").format(
            MOST_STEPS, option_text(option), len(set(numbers))))
    return sorted(set(numbers))


# Making one

def add(mesh, frequencies=None, divisions=None, sizes=None, formats=(), folder="", keep=None, name="Series"):
    """A new series of a mesh object, as one step of undo; nothing is meshed yet.

    One of frequencies, divisions, sizes: a list, or a text as values_of() takes it. formats, folder: endings of files to write for each
    step, and where. keep: whether the steps become mesh objects; None: where no files are asked for.
    ValueError, in one sentence, for what cannot be done; the document is then as before.
    """
    given = {option: values for option, values in zip(VARIED, (frequencies, divisions, sizes)) if values is not None}
    if len(given) != 1:
        raise ValueError(translate("Paver", "A series varies one thing; give it frequencies, or divisions, or sizes."))
    (option, values), = given.items()
    steps = [Step(i, option, value) for i, value in enumerate(values_of(option, values))]
    check(mesh, steps[0], formats, folder)
    document = mesh.Document
    with meshing.transaction(document, "Series of " + mesh.Label), proxies.new_object(document, "App::FeaturePython", name) as obj:
        SeriesProxy(obj)
        obj.Mesh, obj.Varied, obj.Values = mesh, option, [step.value for step in steps]
        obj.Formats, obj.Folder, obj.Rows = list(formats), os.path.abspath(folder) if folder else "", [""] * len(steps)
        if keep or keep is None and not formats:
            obj.Meshes = [new_mesh(mesh, step) for step in steps]
            obj.MeshNames = [child.Name for child in obj.Meshes]
    return obj


def check(mesh, step, formats, folder):
    """ValueError for what can be seen before any work."""
    if not proxies.sources(mesh):
        raise ValueError(translate("Paver", "'{}' has no object to mesh; set its property Part.").format(mesh.Label))
    if step.option == DIVISIONS and not mesh.Frequency.Value > 0:
        raise ValueError(translate("Paver", "'{}' has no frequency, so there are no elements per wavelength to vary; give it "
                                   "one, or vary the size.").format(mesh.Label))
    for ending in formats:
        export_mesh.ending_of("mesh." + ending)
    if formats and not (os.path.isdir(folder) and os.access(folder, os.W_OK)):
        raise ValueError(translate("Paver", "Files cannot be written to the folder '{}'; choose one that exists and can be "
                                   "written to.").format(folder))
    properties.merged(mesh, step.changes)


def new_mesh(mesh, step):
    """The mesh object of a step, hidden and not meshed yet."""
    child = mesh_object.add(mesh.Document, proxies.sources(mesh), f"{mesh.Name}_{step.number + 1}",
                            **properties.merged(mesh, step.changes))
    child.Label = f"{mesh.Label} {step.text}"
    child.RunIn, child.WireRadius, child.Visibility = mesh.RunIn, mesh.WireRadius, False
    copy_children(mesh, child)
    return child


def copy_children(mesh, child):
    """Gives a mesh object children of its own like those of another one: what is changed there later changes no step."""
    for other in refinement.of_mesh(mesh):
        refinement.make(child, other.References, **refinement.value_of(other)).Label = other.Label
    for other in named_parts.of_mesh(mesh):
        named_parts.copy(other, child)


# What there is

def is_series(obj):
    return proxies.type_of(obj) == proxies.SERIES


def of_document(document):
    return [obj for obj in document.Objects if is_series(obj)]


def step_meshes(document):
    """The mesh objects of the steps of all series."""
    return [child for made in of_document(document) for child in made.Meshes]


def steps_of(obj):
    return [Step(number, obj.Varied, value) for number, value in enumerate(obj.Values)]


def mesh_of(obj, number):
    """The mesh object of a step; None where there is none, or none any more."""
    name = obj.MeshNames[number] if number < len(obj.MeshNames) else ""
    return next((child for child in obj.Meshes if child.Name == name), None)


def has_changed(obj, step, row):
    """Whether a step would come to something else by now, or has, than its Row tells about."""
    child = mesh_of(obj, step.number)
    if not row.is_meshed:
        return False
    if child is not None:
        return child.Status != mesh_object.UP_TO_DATE or child.Quads + child.Triangles != row.elements or (
            abs(child.WorstScaledJacobian - row.least_sj) > 1e-6)
    if not row.shape or obj.Mesh is None or core.problem():  # nothing to tell it by
        return False
    shape, changes = mesh_object.shape_digest(obj.Mesh), properties.merged(obj.Mesh, step.changes)
    is_same = row.shape == shape or (row.shape, shape) == getattr(obj.Proxy, "reopened", None)
    return not is_same or row.options != digest_of_options(mesh_object.decisive(obj.Mesh, changes))


def digest_of_options(decisive):
    return source_shapes.digest_of(decisive.encode())


def rows_of(obj):
    """[Row, or None where the step has not been done]."""
    return [as_of_now(obj, step, row_of_text(text)) for step, text in zip(steps_of(obj), obj.Rows)]


def as_of_now(obj, step, row):
    """A Row, or None. One of before a change is none to rely on."""
    if row is None or not has_changed(obj, step, row):
        return row
    return row._replace(verdict=mesh_check.WARNING, reason=translate(
        "Paver", "The model, the options or the mesh have changed since; this row is of before."))


def steps_to_do(obj):
    """Those that have not been done, or would come to something else by now."""
    rows = map(row_of_text, obj.Rows)
    return [step for step, row in zip(steps_of(obj), rows) if row is None or has_changed(obj, step, row)]


def row_of_text(text):
    fields = json.loads(text) if text else None
    return fields and Row(**{name: value for name, value in fields.items() if name in Row._fields})


def put_row(obj, number, row):
    rows = list(obj.Rows)
    rows[number] = json.dumps(row._asdict()) if row else ""
    obj.Rows = rows


def cells(step, row):
    """[text] of COLUMNS; those of figures are empty without a mesh."""
    figures = [row.elements, row.unknowns, row.matrix_bytes, f"{row.seconds:.3f}", f"{row.least_sj:.4f}", row.verdict,
               row.reason] if row and row.is_meshed else [""] * 7
    return [repr(step.value), *map(str, figures), row.error if row else "not done", " ".join(map(os.path.basename, row.files)) if row else ""]


def write_csv(obj, path):
    """Writes the table. NotWritten when that cannot be done."""
    with export_mesh.whole_file(path) as part, open(part, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow((obj.Varied + {FREQUENCY: "_Hz", SIZE: "_mm"}.get(obj.Varied, ""), *COLUMNS[1:]))
        writer.writerows(cells(step, row) for step, row in zip(steps_of(obj), rows_of(obj)))
    return path


# Doing one

class Plan(NamedTuple):
    """What is written of a step: paths, and groups for FreeCAD's formats as analysis.references() has them."""

    paths: tuple = ()
    references: tuple = ()
    is_alone: bool = True


def stem_of(obj):
    """Path that the names of a series' files begin with."""
    return os.path.join(obj.Folder, f"{obj.Document.Name}-{obj.Mesh.Name}")


def table_path(obj):
    return stem_of(obj) + "-series.csv"


def plan_of(obj, step, stem=None):
    """stem: of the files' paths, without it that of the mesh object's name in the series' folder."""
    if not obj.Formats:
        return Plan()
    mesh = obj.Mesh
    sources, stem = proxies.sources(mesh), stem or stem_of(obj)
    return Plan(tuple(f"{stem}-{step.file_text}.{ending}" for ending in obj.Formats),
                tuple(analysis.references(mesh, sources)), len(sources) < 2)


def row_of(mesh, file, seconds, plan, folder, cancel=None):
    """The Row of a StoredMesh, which is in `file` too, and its files, in any thread. folder: for what is needed meanwhile."""
    figures = statistics.of_mesh(mesh)
    findings = mesh_check.in_order(mesh_check.of_mesh(mesh, figures))
    unknowns = statistics.unknowns(figures)
    row = Row(figures.quads + figures.triangles, unknowns, statistics.BYTES_DOUBLE * unknowns ** 2, seconds,
              float(figures.sj.min()) if len(figures.sj) else 0.0, mesh_check.verdict(findings), findings[0].text)
    written = []
    try:
        for path in plan.paths:
            export_mesh.write_file(mesh, file, path, plan.references, plan.is_alone, folder, cancel)
            written.append(path)
    except (export_mesh.NotWritten, child_process.ChildDied) as error:
        row = row._replace(error=str(error))
    return row._replace(files=tuple(written))


def failed_row(error, seconds=0.0):
    return Row(seconds=seconds, error=str(error).strip() or type(error).__name__)


def folder_for(document):
    """A folder for the time being, on the disk that the document has its own files on."""
    return tempfile.TemporaryDirectory(prefix="paver", dir=os.path.dirname(document.TransientDir))


def work(obj, progress=None, cancel=None, stem=None):
    """Does the steps_to_do(), and gives each as a Done; those that fail too. Stops where `cancel` is set.

    progress(stage, fraction) and cancel are those of paver.mesh.
    """
    for step in steps_to_do(obj):
        try:
            yield do_step(obj, step, progress, cancel, stem)
        except core.load().Cancelled:
            return


def do_step(obj, step, progress, cancel, stem):
    child, start = mesh_of(obj, step.number), time.monotonic()
    try:
        job = meshing.prepare(child) if child else meshing.prepare(obj.Mesh, **step.changes)
        with folder_for(obj.Document) as folder:
            path = os.path.join(folder, child_process.MESH)
            mesh = mesh_job.store(job, path, progress or (lambda *_: None), cancel)
            row = row_of(mesh, path, time.monotonic() - start, plan_of(obj, step, stem), folder, cancel)
            keep(obj, step, row, job, mesh, path)
        return Done(step, row, mesh, None)
    except core.load().Cancelled:
        raise
    except Exception as error:
        row = failed_row(error, time.monotonic() - start)
        keep(obj, step, row)
        return Done(step, row, None, error)


def keep(obj, step, row, job=None, mesh=None, file=None, is_outdated=False):
    """Keeps what came of a step in the series, and the mesh in the step's mesh object, as one step of undo."""
    child = mesh_of(obj, step.number)
    if job:
        row = row._replace(shape=job.digest, options=digest_of_options(job.decisive))
    with meshing.transaction(obj.Document, f"Mesh {obj.Label} {step.text}"):
        put_row(obj, step.number, row)  # first: what follows joins a step of undo that has begun to change something
        if child and mesh is not None:
            meshing.keep(child, job, mesh, file, is_outdated)


def run(mesh, frequencies=None, divisions=None, sizes=None, formats=(), folder="", progress=None, cancel=None):
    """Meshes a series of a mesh object, step by step, and gives the series object: rows_of() has the table. Arguments
    and errors as those of add(); a step that fails is a row that says why."""
    obj = add(mesh, frequencies, divisions, sizes, formats, folder)
    for _ in work(obj, progress, cancel):
        pass
    if formats:
        write_csv(obj, table_path(obj))
    return obj
