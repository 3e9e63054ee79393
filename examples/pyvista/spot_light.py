"""Three coloured spot lights: where one of them is in shadow the other two mix."""

import without_display  # noqa: F401
import numpy as np
import pyvista as pv
import vtkshadow.pyvista  # noqa: F401

# Radius and height along a pawn and a bishop of chess.
PAWN = [(0.5, 0), (0.5, 0.12), (0.36, 0.22), (0.18, 0.5), (0.15, 0.85), (0.3, 0.95), (0.15, 1.02), (0.24, 1.1),
        (0.29, 1.25), (0.24, 1.42), (0.12, 1.52), (0, 1.54)]
BISHOP = [(0.55, 0), (0.55, 0.15), (0.4, 0.28), (0.2, 0.7), (0.16, 1.3), (0.36, 1.42), (0.18, 1.5), (0.3, 1.72),
          (0.3, 1.9), (0.14, 2.25), (0.09, 2.32), (0.1, 2.42), (0, 2.48)]


def turned(profile):
    """The surface of a line turned about the axis."""
    points = np.array([(radius, 0, height) for radius, height in profile])
    return pv.Spline(points, 150).extrude_rotate(resolution=90, capping=False)


def build(**options):
    plotter = pv.Plotter(lighting="none", **options)
    plotter.set_background("#101014")
    for profile, x, y in [(BISHOP, 0, 0.3), (PAWN, -1.5, -0.4), (PAWN, 1.4, -0.6)]:
        plotter.add_mesh(turned(profile).translate((x, y, 0)), color="white", smooth_shading=True, specular=0.4,
                         specular_power=40)
    plotter.add_mesh(pv.Plane(i_size=40, j_size=40), color="white")
    for color, x, y in [("#ff5040", -4, -4), ("#40ff70", 0, -5.5), ("#5070ff", 4, -4)]:
        spot = pv.Light(position=(x, y, 6), focal_point=(0, 0.2, 0.5), color=color, light_type="scene light")
        spot.positional = True
        spot.cone_angle = 24
        spot.exponent = 4
        spot.intensity = 0.6
        plotter.add_light(spot)
    plotter.add_light(pv.Light(light_type="headlight", intensity=0.1))
    plotter.camera_position = [(0.6, -8.5, 5.2), (0, 0.5, 0.7), (0, 0, 1)]

    plotter.exact_shadows.enable()
    return plotter


if __name__ == "__main__":
    build().show()
