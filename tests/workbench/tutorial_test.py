"""The pages of tutorials: what they say comes of walking through them in FreeCAD's window, and they stay short and small."""
import json
import os
import re
import subprocess
import sys

import freecad_program
import pytest

from repo import ROOT

FOLDER = os.path.join(ROOT, "Resources", "docs", "tutorials")
STEPS = os.path.join(ROOT, "scripts", "tutorials")
MOST_STEPS, LARGEST, LARGEST_OF_ALL = 10, 60_000, 2_000_000  # bytes
WALKED = "one_body"  # the others take longer, and use the same window
LINK = re.compile(r"\]\(([^)]+)\)")
SECONDS = re.compile(r"\d+(\.\d+)? s\b")

sys.path.append(STEPS)
import catalogue  # noqa: E402


def text_of(folder, name):
    with open(os.path.join(folder, name + ".md"), encoding="utf-8") as file:
        return file.read()


def without_times(text):
    """And without the version of FreeCAD, and in small letters: versions write menus in other ones."""
    return re.sub("FreeCAD [0-9.]+", "FreeCAD", SECONDS.sub("", text)).lower()


def steps_of(text):
    """[(title, words and picture)] of a page."""
    parts = re.split(r"^## \d+\. (.*)$", text, flags=re.M)[1:]
    return list(zip(parts[::2], parts[1::2]))


def test_a_page_is_what_a_walk_in_the_window_tells(tmp_path):
    freecad_program.need_window()
    if os.environ.get("CI") != "true":
        pytest.importorskip("PIL")
    done = subprocess.run([sys.executable, os.path.join(ROOT, "scripts", "tutorial"), WALKED, "--out", str(tmp_path)],
                          stdin=subprocess.DEVNULL, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert without_times(text_of(tmp_path, WALKED)) == without_times(text_of(FOLDER, WALKED)), "run scripts/tutorial"
    assert text_of(tmp_path, "README") == text_of(FOLDER, "README"), "run scripts/tutorial"
    made = sorted(name for name in os.listdir(tmp_path / "pictures"))
    assert made == [f"{WALKED}_{number:02d}.png" for number in range(1, len(made) + 1)] and made


def test_a_step_that_does_not_do_what_it_says_ends_the_walk(tmp_path):
    freecad_program.need_window()
    (tmp_path / "wrong.py").write_text('MODEL = "box.step"\n\n\ndef walk(it):\n    it.step("Wrong", it.press("No such button"))\n')
    order, told = tmp_path / "order.json", tmp_path / "told.json"
    order.write_text(json.dumps({"name": "wrong", "scripts": [STEPS, str(tmp_path)], "models": "", "pictures": str(tmp_path),
                                 "told": str(told), "size": [960, 720]}))
    done = freecad_program.run_window([os.path.join(STEPS, "walk.FCMacro")], freecad_program.profile(tmp_path / "profile"),
                                      PAVER_WALK=str(order))
    assert done.returncode != 0 and "there is a button No such button" in done.stdout + done.stderr
    assert not told.exists()


@pytest.mark.parametrize("name", catalogue.NAMES)
def test_a_page_is_short_and_has_a_picture_of_each_step(name):
    text, shown = text_of(FOLDER, name), []
    steps = steps_of(text)
    assert 0 < len(steps) <= MOST_STEPS
    for number, (title, body) in enumerate(steps, 1):
        words, picture = body.strip().split("\n\n")[:2]
        assert picture == f"![{title}](pictures/{name}_{number:02d}.png)"
        assert len(re.findall(r"[.?!](?= [A-Z*`]|$)", words)) <= 3, words
        shown.append(os.path.basename(LINK.findall(picture)[0]))
    there = sorted(file for file in os.listdir(os.path.join(FOLDER, "pictures")) if file.startswith(name + "_"))
    assert there == shown
    assert f"({name}.md)" in text_of(FOLDER, "README")


def test_pages_and_pictures_are_small():
    folder = os.path.join(FOLDER, "pictures")
    sizes = {name: os.path.getsize(os.path.join(folder, name)) for name in os.listdir(folder)}
    assert sum(sizes.values()) <= LARGEST_OF_ALL
    assert not [name for name, size in sizes.items() if size > LARGEST]
    assert not [name for name in sizes if not name.startswith(tuple(f"{known}_" for known in catalogue.NAMES))]


def test_help_and_the_first_page_lead_there():
    for page in ("README.md", "Resources/docs/help_en.md", "Resources/docs/help_de.md"):
        with open(os.path.join(ROOT, page), encoding="utf-8") as file:
            assert "tutorials/README.md" in file.read(), page
