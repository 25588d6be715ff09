"""Meshing without a window: opens models, meshes, saves, exports, reports. Workbench/mesh.FCMacro runs main()."""
import argparse
import json
import os
import re
import sys

import FreeCAD

from paver_wb import core, export_mesh, mesh_object, meshing, properties, series

EPILOG = ("Exit codes: 0 all is meshed, {internal} internal error, {bad_option} bad usage or option, {damaged_file} bad model, "
          "{face_failed} some face failed, {too_many_elements} more elements predicted than allowed, {unwritable_output} an "
          "output cannot be written, {cancelled} cancelled; of several the first.")


class Parser(argparse.ArgumentParser):
    """With errors as the core has them."""

    def error(self, message):
        unknown = "unrecognized arguments: "
        if message.startswith(unknown):
            message = "The following argument was not expected: " + message[len(unknown):].split()[0]
        raise fault(message + ("" if message.endswith(".") else "."), "bad_option")


def fault(text, code):
    """An error as the core has them: one sentence, and what went wrong."""
    return core.load().Error(text, code)


def parser():
    """Arguments; those of the mesh come from the core's table of options."""
    made = Parser(prog="freecadcmd mesh.FCMacro --", allow_abbrev=False, epilog=EPILOG.format(**core.load()._paver.exit_codes()),
                                   description="Meshes FreeCAD documents and CAD files without a window.")
    made.add_argument("models", nargs="+", metavar="MODEL", help="document (.FCStd) or CAD file (STEP, IGES, BREP)")
    made.add_argument("--objects", metavar="A,B", type=names_of, help="mesh objects, or objects to mesh, by name or "
                      "label [all mesh objects of a document]")
    made.add_argument("--save", action="store_true", help="save the document; that of a CAD file as NAME-mesh.FCStd")
    made.add_argument("--export", metavar="F,G", type=names_of, default=[],
                      help="files to write for each mesh: " + ", ".join(series.FORMATS))
    made.add_argument("--folder", metavar="DIR", help="for exports and documents of CAD files [that of the model]")
    made.add_argument("--report", metavar="R.json", help="report of all runs")
    made.add_argument("--series", metavar="OPTION=A,B", type=series_of, help="a mesh for each value of frequency, divisions or "
                      "size, such as divisions=6,8,10 or frequency=1GHz:4GHz:7:log, and a table of them, NAME-series.csv")
    made.add_argument("--frequencies", metavar="A,B", dest="series", type=lambda text: series_of("frequency=" + text),
                      help="the same as --series frequency=A,B")
    group = made.add_argument_group("options of the mesh, in place of those of the mesh objects")
    for info in core.load().options():
        default = f" [{info['default']}]" if info["default"] else ""
        group.add_argument(dashed(info["name"]), metavar=info["letter"],
                           action="append" if info["kind"] in properties.REPEATED else "store", help=(info["help"] + default).replace("%", "%%"))
    return made


def dashed(name):
    return "--" + name.replace("_", "-")


def with_dashes(text):
    """A sentence of the core with the options called as they are written here: "max_turn" becomes "--max-turn"."""
    for name in (info["name"] for info in core.load().options()):
        if "_" in name:
            text = re.sub(rf"(?<![\w-]){name}\b", dashed(name), text)
        else:
            text = re.sub(rf"(^|(?<=: )|(?<= needs )|(?<= excludes )|(?<= leave )){name}\b(?=[ ;])", dashed(name), text, count=1)
    return text


def given_options(arguments):
    """{option: text, or texts of `local`} of the arguments."""
    names = [info["name"] for info in core.load().options()]
    return {name: getattr(arguments, name) for name in names if getattr(arguments, name) is not None}


def check_options(options, is_whole):
    """The core's error for a value that it does not read, with its words; is_whole: there are no others than these."""
    paver, texts = core.load(), dict(options)
    if not is_whole:  # those of the mesh objects come to them
        needs = {info["name"]: info["needs"] for info in paver.options()}
        texts = {name: value for name, value in texts.items() if not needs[name] or needs[name] in texts}
        texts = texts if {"size", "frequency"} & set(texts) else {**texts, "size": "1"}
    listed = [(name, text) for name, value in texts.items() for text in (value if isinstance(value, list) else [value])]
    nothing = paver._paver.Source.of_bytes(b"", b"", [])
    try:
        paver._paver.predict(nothing, listed, None)  # which looks at the options first
    except paver.OptionError:
        raise
    except paver.InputError:
        pass


def names_of(text):
    return [name.strip() for name in text.split(",") if name.strip()]


def series_of(text):
    """(option, its values) of --series."""
    option, _, values = text.partition("=")
    try:
        if option not in series.VARIED:
            raise ValueError(f"A series varies {', '.join(series.VARIED)}, not '{option}'; write for instance divisions=6,8,10.")
        return option, series.values_of(option, values)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def check_arguments(arguments):
    """An error for what can be seen before any work."""
    bad = [name for name in arguments.export if name not in series.FORMATS]
    if bad:
        raise fault(f"--export has '{bad[0]}'; write some of {', '.join(series.FORMATS)}.", "bad_option")
    stems = [output_stem(arguments, path) for path in arguments.models]
    twice = [path for path, stem in zip(arguments.models, stems) if stems.count(stem) > 1]
    if twice and (arguments.export or arguments.save or arguments.series):
        raise fault(f"The outputs of {' and '.join(twice)} would have the same names; run them one by one with "
                    "another --folder.", "bad_option")
    first = [arguments.report] if arguments.report else []
    first += [f"{stem}.{ending}" for stem in stems for ending in arguments.export[:1]]
    for path in first:
        if not os.path.isdir(os.path.dirname(os.path.abspath(path))):
            raise fault(f"Cannot write '{path}': no such file or directory; make that folder, or choose another "
                        "one.", "unwritable_output")
    if arguments.folder and not os.path.isdir(arguments.folder):
        raise fault(f"The folder {os.path.abspath(arguments.folder)} does not exist; make it, or name another.", "unwritable_output")


def output_stem(arguments, path):
    stem = os.path.splitext(os.path.basename(path))[0]
    return os.path.join(os.path.abspath(arguments.folder or os.path.dirname(path) or "."), stem)


def is_document(path):
    return path.lower().endswith(".fcstd")


def open_model(path):
    """The document of a file; for a CAD file a new one with its shape as the only object, labelled by its name."""
    if not is_document(path):
        core.load().Model(path).parts()  # an error of the core where it is no model: FreeCAD reads half of a cut one
    elif not os.path.isfile(path):
        raise fault(f"'{path}' does not exist; check the path.", "file_missing")
    try:
        if is_document(path):
            return FreeCAD.openDocument(path, hidden=True)
        import Part
        shape = Part.read(path)
    except Exception as error:
        raise fault(f"{path} cannot be read ({str(error).strip()}); pass a document or a STEP, IGES or BREP file.",
                    "damaged_file") from None
    document = FreeCAD.newDocument("Model", hidden=True)
    model = document.addObject("Part::Feature", "Shape")
    model.Shape, model.Label = shape, os.path.basename(path)
    return document


def named(document, path, name):
    """An object by its name, else by its label if that is unique."""
    found = document.getObject(name) or (document.getObjectsByLabel(name) or [None])[0]
    if found is None or (found.Name != name and len(document.getObjectsByLabel(name)) > 1):
        known = ", ".join(thing.Name for thing in document.Objects)
        what = "no object" if found is None else "several objects labelled"
        raise fault(f"{path} has {what} '{name}'; its objects are {known}.", "bad_option")
    return found


def targets(document, path, names):
    """Mesh objects to mesh; they are made for named objects that are none and for CAD files."""
    if names:
        things = [named(document, path, name) for name in names]
    elif is_document(path):
        steps = series.step_meshes(document)
        things = [mesh for mesh in mesh_object.meshes_of(document) if mesh not in steps]
        if not things:
            raise fault(f"{path} has no mesh object; name the objects to mesh with --objects.", "bad_option")
    else:
        things = document.Objects
    return [thing if mesh_object.is_mesh(thing) else mesh_object.add(document, thing, thing.Name + "Mesh")
            for thing in things]


def export(obj, stem, formats):
    """Writes the files; their paths."""
    paths = []
    for ending in formats:
        paths.append(f"{stem}.{ending}")
        try:
            export_mesh.write(obj, paths[-1])
        except export_mesh.NotWritten as error:
            is_usage = isinstance(error, export_mesh.CannotHold)
            raise fault(str(error), "bad_option" if is_usage else "unwritable_output") from None
    return paths


def failed_faces(result):
    """The core's sentence on faces that could not be meshed."""
    try:
        result._data.check()
    except core.load().FaceError as error:
        return str(error)
    return None


def failure(error):
    """What an exception puts into an entry of the report."""
    code = getattr(error, "code", "bad_option" if isinstance(error, ValueError) else "internal")
    return {"status": "failed", "exit_code": core.exit_code(code), "error": with_dashes(str(error))}


def new_entry(obj=None):
    """An entry of the report of what went well so far."""
    return {"object": obj and obj.Name, "label": obj and obj.Label, "status": "meshed", "exit_code": 0, "error": None, "files": [],
            "report": None}


def run_object(obj, stem, options, formats):
    """Meshes one object and exports it; its entry of the report."""
    entry = new_entry(obj)
    try:
        properties.put(obj, options)
        result = meshing.mesh(obj)
        entry["report"] = result.report
        if obj.FailedFaces:
            entry.update(status="faces_failed", exit_code=core.exit_code("face_failed"), error=failed_faces(result))
        entry["files"] = export(obj, stem, formats)
    except Exception as error:
        entry.update(failure(error))
    return entry


def run_series(obj, stem, options, arguments):
    """Meshes the steps of a series of one object; their entries of the report."""
    entries, (option, values) = [], arguments.series
    try:
        properties.put(obj, options)
        made = series.add(obj, **{series.ARGUMENTS[option]: values}, formats=arguments.export, folder=os.path.dirname(stem),
                          keep=arguments.save)
        for done in series.work(made, stem=stem):
            entries.append(entry_of(obj, done))
        entries[-1]["files"].append(series.write_csv(made, stem + "-series.csv"))
    except Exception as error:
        entries.append({**new_entry(obj), **failure(error)})
    return entries


def entry_of(obj, done):
    """The entry of the report of a step that has ended."""
    entry = {**new_entry(obj), "files": list(done.row.files), "report": done.mesh and done.mesh.report,
             "step": {done.step.option: done.step.value}, "table": done.row._asdict()}
    lost = meshing.failed_faces(done.mesh) if done.mesh else []
    if done.error:
        entry.update(failure(done.error))
    elif lost:
        entry.update(status="faces_failed", exit_code=core.exit_code("face_failed"), error="; ".join(lost))
    elif done.row.error:
        entry.update(status="failed", exit_code=core.exit_code("unwritable_output"), error=done.row.error)
    return entry


def save(document, path, stem):
    """Saves the document; its path."""
    saved = path if is_document(path) else stem + "-mesh.FCStd"
    try:
        document.save() if is_document(path) else document.saveAs(saved)
    except Exception as error:
        raise fault(f"{saved} cannot be saved ({str(error).strip()}); check the folder.", "unwritable_output") from None
    return saved


def run_model(path, arguments, options):
    """Entries of the report for one model. The document is closed again, whatever happens."""
    stem, entries, document = output_stem(arguments, path), [], None
    try:
        document = open_model(path)
        meshes = targets(document, path, arguments.objects)
        for obj in meshes:
            of_object = stem if len(meshes) == 1 and not is_document(path) else f"{stem}-{obj.Name}"
            entries += run_series(obj, of_object, options, arguments) if arguments.series else [
                run_object(obj, of_object, options, arguments.export)]
        if arguments.save and any(entry["status"] != "failed" for entry in entries):
            entries[0]["files"].append(save(document, path, stem))
    except Exception as error:
        entries.append({**new_entry(), **failure(error)})
    finally:
        if document is not None:
            FreeCAD.closeDocument(document.Name)
    return [{"model": path, **entry} for entry in entries]


def show(entry):
    """A line on what became of a mesh; errors go to the error output."""
    where = entry["model"] + (f", {entry['object']}" if entry["object"] else "")
    where += "".join(f", {series.Step(0, *step).text}" for step in entry.get("step", {}).items())
    if entry["report"]:
        quality = entry["report"]["quality"]
        print(f"{where}: {quality['quads']} quads, {quality['triangles']} triangles", flush=True)
    if entry["error"]:
        print(f"{where}: {entry['error']}", file=sys.stderr, flush=True)


def write_report(path, content):
    part = f"{path}.{os.getpid()}"
    try:
        with open(part, "w", encoding="utf-8") as file:
            json.dump(content, file, indent=1)
        os.replace(part, path)
    except OSError as error:
        raise fault(f"{path} cannot be written ({error.strerror}); check the folder.", "unwritable_output") from None


def main(arguments):
    """Exit code."""
    try:
        arguments = parser().parse_args(arguments)
        check_arguments(arguments)
        options = given_options(arguments)
        first = {arguments.series[0]: repr(arguments.series[1][0])} if arguments.series else {}
        check_options({**options, **first}, not any(map(is_document, arguments.models)))
        entries = []
        for path in arguments.models:
            of_model = run_model(path, arguments, options)
            entries += of_model
            for entry in of_model:
                show(entry)
        code = next((entry["exit_code"] for entry in entries if entry["exit_code"]), 0)
        if arguments.report:
            write_report(arguments.report, {"report_version": 1, "exit_code": code, "runs": entries})
        return code
    except core.CoreMissing as error:
        print(error, file=sys.stderr)
        return 1
    except core.load().Error as error:
        print(with_dashes(str(error)), file=sys.stderr)
        return core.exit_code(error.code)
