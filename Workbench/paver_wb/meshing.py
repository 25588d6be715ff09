"""Meshing of a mesh object, as it is asked for by commands, scripts and jobs."""
from contextlib import contextmanager

import FreeCAD

from paver_wb import analysis, core, mesh_object, properties, refinement
from paver_wb.base import expressions, source_shapes
from paver_wb.children import named_parts
from paver_wb.formats import fem_mesh, mesh_file
from paver_wb.processes import mesh_job
from paver_wb.processes.mesh_job import Job

translate = FreeCAD.Qt.translate

@contextmanager
def transaction(document, name):
    """One step of undo; a part of the caller's step where that has one open."""
    is_own = not document.HasPendingTransaction
    if is_own:
        document.openTransaction(name)
    try:
        yield
    except BaseException:
        if is_own:
            document.abortTransaction()
        raise
    if is_own:
        document.commitTransaction()


def prepare(obj, **changes):
    """The Job of a mesh object as it is now, but with `changes` of its options, as properties.put takes them.

    Looks at the document, so only in the main thread. InputError without anything to mesh, ValueError for bad changes.
    """
    paver = core.load()
    from paver import _shapes
    parts = mesh_object.sources(obj)
    if not parts:
        raise paver.InputError(translate("Paver", "'{}' has no object to mesh; set its property Part.").format(obj.Label),
                               "no_faces", "set its property Part")
    properties.check_ranks(obj)
    shape, name, labels = _shapes.source_of(parts, None)
    decisive = mesh_object.decisive(obj, properties.merged(obj, changes))
    return Job(shape, name, labels, options_of(obj, changes), tuple(part.Name for part in parts),
               source_shapes.digest_of(shape), decisive)


def prepare_like(job, obj, **changes):
    """The same where a mesh object meshes the very shapes of a Job that is there."""
    return job._replace(options=options_of(obj, changes), decisive=mesh_object.decisive(obj, properties.merged(obj, changes)))


def options_of(obj, changes):
    """Options of a mesh object with `changes`, as paver.mesh takes them, with its refinements, media, ports and wires."""
    for thing in (obj, *refinement.of_mesh(obj), *named_parts.of_mesh(obj)):
        expressions.check(thing)
    options, sources = properties.merged(obj, changes), mesh_object.sources(obj)
    for name, texts in {"local": refinement.local_texts(obj, sources), **named_parts.option_texts(obj, sources)}.items():
        if texts:
            options[name] = options.get(name, []) + texts
    return options


def has_changed(obj, job, known):
    """Whether a mesh object's shape differs from that of a job, which was prepared with the shapes `known`."""
    try:
        shapes = source_shapes.of(mesh_object.sources(obj))
        return not source_shapes.are_same(shapes, known) and mesh_object.shape_digest(obj) != job.digest
    except (core.load().InputError, ReferenceError):
        return True


def show_results(obj, mesh):
    """The properties that tell about the mesh."""
    quality = mesh.report["quality"]
    obj.Quads, obj.Triangles, obj.Nodes = len(mesh.quads), len(mesh.triangles), len(mesh.nodes)
    obj.Lines = quality.get("wire_lines", 0)
    obj.TargetLength = mesh.report["target_length"]
    obj.WorstScaledJacobian = quality["sj"]["all"]["min"]
    obj.Watertight = quality["watertight"]
    obj.FailedFaces = failed_faces(mesh)


def failed_faces(mesh):
    """["Face3: reason"] of a StoredMesh."""
    return [f"{label}: {face['reason']}" for label, face in zip(mesh_file.labels(mesh), mesh.report["faces"])
            if face["status"] == "failed"]


def keep(obj, job, mesh, file=None, is_outdated=False, run_in=None, **changes):
    """Keeps a job's StoredMesh, and the changes of options it was made with, in its mesh object as one step of undo.

    run_in: the value that RunIn gets, or None. file: where the mesh is written already; it is moved, and must lie on the document's disk. is_outdated: the shape is
    not that of the job any more. The first mesh hides its sources.
    """
    hides_sources = not obj.MeshFile and obj.Visibility  # the 3D view would show spots of both
    is_filled = is_filled_unasked(mesh) or bool(analysis.analyses_of(obj))
    fem = mesh_object.fem_mesh_of(obj, mesh) if is_filled else fem_mesh.empty()
    with transaction(obj.Document, "Mesh " + obj.Label):
        properties.put(obj, changes)
        if run_in is not None and run_in != obj.RunIn:
            obj.RunIn = run_in
        mesh_object.keep(obj, file or mesh)
        show_results(obj, mesh)
        obj.MeshedShape, obj.MeshedOptions, obj.ShapeChanged = job.digest, job.decisive, is_outdated
        obj.MeshedLabels = source_shapes.digest_of(repr(job.labels).encode())
        obj.FemMesh, obj.FemMeshFilled = fem, is_filled
        for source in mesh_object.sources(obj) if hides_sources else ():
            if may_be_hidden(source):
                source.Visibility = False
        mesh_object.check_labels(obj)
        mesh_object.tell_readers(obj)
    mesh_object.untouch(obj)


def may_be_hidden(source):
    """FreeCAD leaves what is hidden inside an App::Part or a link array out of that one's shape."""
    from paver import _shapes
    return _shapes.enclosing(source) is None


def is_filled_unasked(mesh):
    return len(mesh.quads) + len(mesh.triangles) <= mesh_object.fill_limit()


def mesh(obj, progress=None, cancel=None):
    """Meshes a mesh object and keeps the result in it, as one step of undo; gives the paver.Result.

    progress(stage, fraction) and cancel are those of paver.mesh. After an error, or when it is stopped, the object is
    as before. Faces that fail are named in FailedFaces; the mesh of the others is kept. The first mesh hides its model,
    as in the window.
    """
    job = prepare(obj)
    result = mesh_job.run(job, progress, cancel)
    keep(obj, job, mesh_job.stored(job, result))
    return result


def fill(obj):
    """Fills FemMesh on demand, for solvers and exports, as one step of undo."""
    with transaction(obj.Document, "Fill FemMesh of " + obj.Label):
        mesh_object.fill(obj)
