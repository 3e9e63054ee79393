"""Draws all scenes of this folder, plain and with exact shadows, and a page that shows them side by side.

Usage: gallery.py [FOLDER]      FOLDER: where to, else gallery; open its index.html
"""

import html
import importlib
import pathlib
import string
import sys

import without_display  # noqa: F401
import pyvista as pv

HERE = pathlib.Path(__file__).resolve().parent
SCENES = ("before_after", "part", "terrain", "molecule", "building", "robot", "point_light", "spot_light", "subplots",
          "ambient_occlusion", "translucent", "gltf")
SIZE = (800, 600)


def build(name, size=SIZE):
    """The plotter of a scene, not shown."""
    return importlib.import_module(name).build(off_screen=True, window_size=size)


def picture(plotter, file=None):
    plotter.render()  # a screenshot alone draws nothing new after the first one
    return plotter.screenshot(file, return_img=True)


def turn_off(plotter):
    """Leaves the scene as it is without exact shadows and outlines."""
    plotter.exact_shadows.all.disable()
    plotter.exact_shadows.all.outlines(None)


def write_page(folder):
    page = string.Template((HERE / "gallery.html").read_text())
    before, section, after = page.template.split("<!-- scene -->\n")
    sections = []
    for name in SCENES:
        script = HERE / f"{name}.py"
        title, _, text = importlib.import_module(name).__doc__.strip().partition(": ")
        values = {"name": name, "title": title, "text": text[:1].upper() + text[1:], "script": script.read_text()}
        values = {key: html.escape(value) for key, value in values.items()}
        sections.append(string.Template(section).substitute(values, width=SIZE[0], height=SIZE[1]))
    (folder / "index.html").write_text(before + "".join(sections) + after)


def main(folder):
    folder.mkdir(parents=True, exist_ok=True)
    # All are kept to the end: with PyVista 0.44 a plotter that is collected may change those that come after it.
    plotters = []
    for name in SCENES:
        plotter = build(name)
        plotters.append(plotter)
        picture(plotter, folder / f"{name}.png")
        print(f"{name}: {plotter.exact_shadows.all.status}".replace("\n", "; "), flush=True)
        turn_off(plotter)
        picture(plotter, folder / f"{name}-plain.png")
    write_page(folder)
    print(folder / "index.html")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "gallery"))
