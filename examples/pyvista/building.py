"""A section through a house: the sun falls through the windows onto floors and walls."""

import without_display  # noqa: F401
import pyvista as pv
import vtkshadow.pyvista  # noqa: F401

PLASTER, SLAB, WOOD = "#f2eee6", "#b5aea4", "#b07d4f"


def block(x, y, z):
    """From corner to corner."""
    return pv.Box((*x, *y, *z))


def wall_with_windows(z):
    """The long wall at the back: below, between and above three windows."""
    yield block((0, 9), (5, 5.2), (z, z + 0.9))
    yield block((0, 9), (5, 5.2), (z + 2.2, z + 2.8))
    for start, end in [(0, 0.8), (2.2, 3.6), (5.2, 6.4), (8, 9)]:
        yield block((start, end), (5, 5.2), (z + 0.9, z + 2.2))


def house():
    for z in (0, 3):
        yield block((-0.2, 9.2), (0, 5.2), (z - 0.2, z)), SLAB
        for wall in wall_with_windows(z):
            yield wall, PLASTER
        for x in (-0.2, 4.4, 9):
            yield block((x, x + 0.2), (0 if x != 4.4 else 1.8, 5), (z, z + 2.8)), PLASTER
        yield block((1, 2.6), (2.2, 3.2), (z + 0.7, z + 0.78)), WOOD
        for x, y in [(1.1, 2.3), (2.4, 2.3), (1.1, 3.0), (2.4, 3.0)]:
            yield block((x, x + 0.1), (y, y + 0.1), (z, z + 0.7)), WOOD
        yield block((6.4, 8.4), (2.6, 4.2), (z, z + 0.45)), WOOD
    yield block((-0.6, 9.6), (0, 5.6), (5.8, 6.0)), SLAB


def build(**options):
    plotter = pv.Plotter(lighting="none", **options)
    plotter.set_background("#dbe7f0", top="#a9c7e0")
    for mesh, color in house():
        plotter.add_mesh(mesh, color=color, ambient=0.25)
    plotter.add_mesh(block((-40, 50), (-40, 50), (-0.6, -0.2)), color="#9fb283", ambient=0.25)
    sun = pv.Light(position=(-2.5, 6, 4.5), color="#fff0d2", light_type="scene light", intensity=0.85)
    plotter.add_light(sun)
    plotter.add_light(pv.Light(light_type="headlight", intensity=0.75))
    plotter.camera_position = [(9.5, -15, 9.5), (4.6, 2, 2.3), (0, 0, 1)]

    plotter.exact_shadows.enable(intensity=0.9)
    plotter.exact_shadows.outlines(width=1.2, color="#4a4540", creases=60)
    return plotter


if __name__ == "__main__":
    build().show()
