"""Subplots: each has settings of its own, from none to shadows with outlines."""

import without_display  # noqa: F401
import pyvista as pv
import vtkshadow.pyvista  # noqa: F401


def stones():
    """A ring of stones, with others across them."""
    for angle in range(0, 360, 30):
        stone = pv.Cube(x_length=0.35, y_length=0.8, z_length=1.8).translate((3, 0, 0.9))
        yield stone.rotate_z(angle)
        if angle not in (60, 90, 210):
            yield pv.Cube(x_length=0.4, y_length=1.48, z_length=0.3).translate((3, 0, 1.95)).rotate_z(angle + 15)
    yield pv.Cube(x_length=0.9, y_length=0.5, z_length=0.5).translate((0, 0, 0.25))


def build(**options):
    plotter = pv.Plotter(shape=(2, 2), lighting="none", border=False, **options)
    for number, title in enumerate(("plain", "intensity=0.5", "shadows", "outlines")):
        plotter.subplot(*divmod(number, 2))
        plotter.set_background("#a8b58a", all_renderers=False)
        for stone in stones():
            plotter.add_mesh(stone, color="#cdc6b8")
        plotter.add_mesh(pv.Disc(inner=0, outer=60, c_res=96), color="#a8b58a")
        plotter.add_light(pv.Light(position=(6, -3, 4.5), light_type="scene light", color="#fff0d8", intensity=0.9),
                          only_active=True)
        plotter.add_light(pv.Light(light_type="headlight", intensity=0.6), only_active=True)
        plotter.add_text(title, font_size=10, color="black")
        plotter.camera_position = [(4, -11, 9), (-0.3, -0.2, 0.2), (0, 0, 1)]

    plotter.exact_shadows.all.enable()
    plotter.subplot(0, 0)
    plotter.exact_shadows.disable()
    plotter.subplot(0, 1)
    plotter.exact_shadows.enable(intensity=0.5)
    plotter.subplot(1, 1)
    plotter.exact_shadows.outlines(width=1.5, creases=40)
    return plotter


if __name__ == "__main__":
    build().show()
