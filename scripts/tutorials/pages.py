"""The pages of tutorials: Markdown and pictures, of the steps that a walk has told."""
import os

from PIL import Image

import catalogue

PICTURES = "pictures"
COLOURS = (160, 100, 60)  # of a picture, until it is small enough
SIGNALS = [235, 85, 0, 200, 30, 45, 250, 200, 50, 40, 130, 60, 30, 140, 240, 153, 26, 217, 0, 0, 0]  # red, green, blue of colours that stay
LARGEST = 60_000          # bytes
MOST_STEPS = 10
MADE = "Made by `scripts/tutorial`, in the window of FreeCAD {}; numbers are those of that run."


def shrink(source, target):
    """A picture with as many colours as there is room for."""
    with Image.open(source) as image:
        image = image.convert("RGB")
        for colours in COLOURS:
            palette = Image.new("P", (1, 1))
            palette.putpalette(image.quantize(colours).getpalette()[:3 * colours] + SIGNALS)
            image.quantize(palette=palette, dither=Image.Dither.NONE).save(target, optimize=True)
            if os.path.getsize(target) <= LARGEST:
                return
    raise ValueError(f"{target} is larger than {LARGEST} bytes; show less.")


def picture_name(name, number):
    return f"{PICTURES}/{name}_{number:02d}.png"


def page(name, steps, version):
    """Markdown of a tutorial. steps: as the walk has told them."""
    tutorial = catalogue.tutorial(name)
    model = os.path.basename(tutorial.MODEL)
    lines = [f"# {tutorial.TITLE}", "", tutorial.ABOUT, "",
             f"Model: [{model}](../../examples/{tutorial.MODEL}). {MADE.format(version)} "
             "What is clicked has an orange frame.", ""]
    for number, step in enumerate(steps, 1):
        lines += [f"## {number}. {step['title']}", "", step["text"], "", f"![{step['title']}]({picture_name(name, number)})", ""]
    after = catalogue.NAMES[catalogue.NAMES.index(name) + 1:]
    following = f"Next: [{catalogue.tutorial(after[0]).TITLE}]({after[0]}.md). " if after else ""
    return "\n".join(lines) + f"\n{following}[All tutorials](README.md)\n"


def index():
    """Markdown of the list of tutorials."""
    lines = ["# Tutorials", "", "Each has a model that comes along, at most ten steps, and a picture of each.", ""]
    for name in catalogue.NAMES:
        tutorial = catalogue.tutorial(name)
        lines.append(f"- [{tutorial.TITLE}]({name}.md): {tutorial.ABOUT}")
    return "\n".join(lines) + """

Choose the workbench *Paver* first, and open the models with *File > Open*: they lie in the folder `Resources/examples` of the
add-on (*Mod/Paver* in FreeCAD's user folder, or the checkout). The pictures show FreeCAD without the toolbars and docks that the
steps do not need, and the 3D view in one colour.

`scripts/tutorial` walks through all of them in FreeCAD's window and writes these pages.
"""


def write(folder, name, steps, version, pictures):
    """Writes a tutorial's page, and its pictures from the folder where the walk has left them."""
    if len(steps) > MOST_STEPS:
        raise ValueError(f"{name} has {len(steps)} steps, at most {MOST_STEPS} are a page.")
    os.makedirs(os.path.join(folder, PICTURES), exist_ok=True)
    for number, step in enumerate(steps, 1):
        shrink(os.path.join(pictures, step["picture"]), os.path.join(folder, picture_name(name, number)))
    with open(os.path.join(folder, name + ".md"), "w", encoding="utf-8") as file:
        file.write(page(name, steps, version))
