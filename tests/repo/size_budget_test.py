"""Files have at most 600 lines, functions at most 80 (C++ and Python) and folders of the core at most 16 files; the
longest functions are printed."""
import ast
import collections
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "../support"))
import repo  # noqa: E402

FILE_LINES, FUNCTION_LINES, FOLDER_FILES = 600, 80, 16
BLANKED = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((?:.|\n)*?\)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.S)
NOT_FUNCTIONS = re.compile(r"^\s*(?:\}?\s*else\b|if\b|for\b|while\b|switch\b|catch\b|do\b|namespace\b|class\b|struct\b"
                           r"|enum\b|union\b|extern\b|try\b|return\b|case\b)")


def functions_cpp(source):
    """(first line, lines) of every outermost function body, found by its braces."""
    source = re.sub(r"^[ \t]*#.*$", "", BLANKED.sub(lambda m: "\n" * m.group().count("\n"), source), flags=re.M)
    found, open_at, depth, header, line = [], None, 0, "", 1
    for c in source:
        line += c == "\n"
        if c == "{":
            is_function = ")" in header and not NOT_FUNCTIONS.match(header.replace("\n", " "))
            if open_at is None and is_function and "= " not in header.split("(")[0]:
                open_at = (line - header.strip().count("\n"), depth)
            depth += 1
            header = ""
        elif c == "}":
            depth -= 1
            if open_at and depth == open_at[1]:
                found.append((open_at[0], line - open_at[0] + 1))
                open_at = None
            header = ""
        elif c == ";" and "(" not in header.rsplit(")", 1)[-1]:
            header = ""
        else:
            header += c
    return found


def functions_python(source):
    nodes = [n for n in ast.walk(ast.parse(source)) if isinstance(n, (ast.FunctionDef, ast.AsyncFunctionDef))]
    return [(n.lineno, n.end_lineno - n.lineno + 1) for n in nodes]


def main():
    faults, longest = [], []
    for name in repo.files(".h", ".cpp", ".py"):
        source = repo.text(name)
        lines = source.count("\n")
        if lines > FILE_LINES:
            faults.append(f"{name}: {lines} lines, at most {FILE_LINES}")
        for at, count in (functions_python if name.endswith(".py") else functions_cpp)(source):
            longest.append((count, f"{name}:{at}"))
            if count > FUNCTION_LINES:
                faults.append(f"{name}:{at}: function of {count} lines, at most {FUNCTION_LINES}")
    folders = collections.Counter(map(os.path.dirname, repo.files(".h", ".cpp", under="core/src")))
    faults += [f"{folder}: {count} files, at most {FOLDER_FILES}; divide it into rooms"
               for folder, count in folders.items() if count > FOLDER_FILES]
    print("longest functions:", ", ".join(f"{where} ({count})" for count, where in sorted(longest)[:-6:-1]))
    repo.finish(faults)


if __name__ == "__main__":
    main()
