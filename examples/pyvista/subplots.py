"""Four times of a day: each subplot has a sun and shadows of its own."""

import without_display  # noqa: F401
import numpy as np
import pyvista as pv
import vtkshadow.pyvista  # noqa: F401

HOURS = {"8:00": (70, 18, "#ffd2a1"), "11:00": (20, 50, "#fff4e0"), "14:00": (-40, 42, "#fff1d6"),
         "17:00": (-80, 14, "#ffbe85")}  # degrees from south and above the horizon, and colour


def stones():
    """A ring of stones, with others across them."""
    for angle in range(0, 360, 30):
        stone = pv.Cube(x_length=0.35, y_length=0.8, z_length=1.8).translate((3, 0, 0.9))
        yield stone.rotate_z(angle)
        if angle not in (60, 90, 210):
            yield pv.Cube(x_length=0.4, y_length=1.75, z_length=0.3).translate((3, 0, 1.95)).rotate_z(angle + 15)
    yield pv.Cube(x_length=0.9, y_length=0.5, z_length=0.5).translate((0, 0, 0.25))


def build(**options):
    plotter = pv.Plotter(shape=(2, 2), lighting="none", border=False, **options)
    for number, (hour, (azimuth, height, color)) in enumerate(HOURS.items()):
        plotter.subplot(*divmod(number, 2))
        plotter.set_background("#cfe0ee", all_renderers=False)
        for stone in stones():
            plotter.add_mesh(stone, color="#b8b2a6")
        plotter.add_mesh(pv.Disc(inner=0, outer=12, c_res=96), color="#93a870")
        south, up = np.radians([azimuth, height])
        towards_sun = (np.sin(south) * np.cos(up), -np.cos(south) * np.cos(up), np.sin(up))
        plotter.add_light(pv.Light(position=towards_sun, color=color, light_type="scene light", intensity=0.8),
                          only_active=True)
        plotter.add_light(pv.Light(light_type="headlight", intensity=0.3), only_active=True)
        plotter.add_text(hour, font_size=10, color="black")
        plotter.camera_position = [(4, -11, 9), (0, -0.2, 0.2), (0, 0, 1)]

    plotter.exact_shadows.all.enable()
    return plotter


if __name__ == "__main__":
    build().show()
