"""Meshing of a mesh object, as it is asked for by commands, scripts and jobs."""
from contextlib import contextmanager

from paver_wb import core, fem_mesh, mesh_file, mesh_object, properties


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


def face_names(parts, result):
    """Names of groups: "Face3" of a single object, "Box_Face3" where several are meshed together."""
    if len(parts) < 2:
        return result.face_names
    names = list(result.face_names)
    for thing, part in reversed(list(zip(parts, result.parts))):  # the first object names what several share
        for number, face in enumerate(part.faces):
            names[face] = f"{thing.Name}_Face{number + 1}"
    return names


def run(obj, progress=None, cancel=None):
    """paver.Result of the object's sources with its options; changes nothing. Faces that fail are left out.

    FaceError when no face can be meshed; other errors as paver.mesh has them.
    """
    paver = core.load()
    parts = mesh_object.sources(obj)
    if not parts:
        raise paver.InputError(f"'{obj.Label}' has no object to mesh; set its property Part.", "no_faces",
                               "set its property Part")
    model = paver.Model(parts)
    try:
        return paver.mesh(model, progress=progress, cancel=cancel, **properties.given(obj))
    except paver.FaceError as error:
        if error.result is None or len(error.result.quads) + len(error.result.triangles) == 0:
            raise
        return error.result


def show_results(obj, mesh):
    """The properties that tell about the mesh."""
    quality = mesh.report["quality"]
    obj.Quads, obj.Triangles, obj.Nodes = len(mesh.quads), len(mesh.triangles), len(mesh.nodes)
    obj.TargetLength = mesh.report["target_length"]
    obj.WorstScaledJacobian = quality["sj"]["all"]["min"]
    obj.Watertight = quality["watertight"]
    obj.FailedFaces = [f"{mesh.face_names[i]}: {face['reason']}" for i, face in enumerate(mesh.report["faces"])
                       if face["status"] == "failed"]


def mesh(obj, progress=None, cancel=None):
    """Meshes a mesh object and keeps the result in it, as one step of undo; gives the paver.Result.

    progress(stage, fraction) and cancel are those of paver.mesh. After an error, or when it is stopped, the object is
    as before. Faces that fail are named in FailedFaces; the mesh of the others is kept.
    """
    digest, options = mesh_object.shape_digest(obj), properties.decisive(obj)
    result = run(obj, progress, cancel)
    made = mesh_file.of_result(result, face_names(mesh_object.sources(obj), result))
    is_filled = len(made.quads) + len(made.triangles) <= mesh_object.fill_limit()
    fem = mesh_object.fem_mesh_of(obj, made) if is_filled else fem_mesh.empty()
    with transaction(obj.Document, "Mesh " + obj.Label):
        mesh_object.keep(obj, made)
        show_results(obj, made)
        obj.MeshedShape, obj.MeshedOptions, obj.ShapeChanged = digest, options, False
        obj.FemMesh, obj.FemMeshFilled = fem, is_filled
        mesh_object.update_status(obj)
    return result


def fill(obj):
    """Fills FemMesh on demand, for solvers and exports, as one step of undo."""
    with transaction(obj.Document, "Fill FemMesh of " + obj.Label):
        mesh_object.fill(obj)
