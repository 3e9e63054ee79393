"""A robot's arm of simple shapes, each joint turned about its axis."""

import without_display  # noqa: F401
import pyvista as pv
import vtkshadow.pyvista  # noqa: F401

ORANGE, GREY, DARK = "#e8742c", "#c9ced4", "#3b4048"


def bar(length, radius):
    """A link, upwards, round at both ends."""
    flat = pv.Cube(center=(0, 0, length / 2), x_length=1.6 * radius, y_length=radius, z_length=length)
    return [(flat, ORANGE), (joint(), DARK), (joint().translate((0, 0, length)), DARK)]


def joint():
    return pv.Cylinder(direction=(0, 1, 0), radius=0.36, height=0.8, resolution=60)


def gripper():
    hand = [(pv.Cube(center=(0, 0, 0.5), x_length=0.9, y_length=0.5, z_length=0.3), GREY)]
    for side in (-0.35, 0.35):
        hand.append((pv.Cube(center=(side, 0, 0.95), x_length=0.12, y_length=0.4, z_length=0.7), DARK))
    return hand


def turned(parts, angle, up):
    """What is beyond a joint: turned about it, and carried to the end of the link before."""
    return [(mesh.rotate_y(angle).translate((0, 0, up)), color) for mesh, color in parts]


def arm(shoulder=-25, elbow=95, wrist=75):
    forearm = bar(1.9, 0.3) + turned(gripper(), wrist, 1.9)
    upper = bar(2.2, 0.42) + turned(forearm, elbow, 2.2)
    foot = [(pv.Cylinder(center=(0, 0, 0.15), direction=(0, 0, 1), radius=1.1, height=0.3, resolution=80), GREY),
            (pv.Cylinder(center=(0, 0, 0.6), direction=(0, 0, 1), radius=0.6, height=0.6, resolution=80), ORANGE)]
    return foot + turned(upper, shoulder, 1.1)


def build(**options):
    plotter = pv.Plotter(lighting="none", **options)
    plotter.set_background("#dfe4ea")
    for mesh, color in arm():
        plotter.add_mesh(mesh, color=color, specular=0.2)
    plotter.add_mesh(pv.Cube(center=(1.75, 0, 0.3), x_length=0.6, y_length=0.6, z_length=0.6), color="#4f8f5b")
    for y in (-1.4, 1.4):
        plotter.add_mesh(pv.Cube(center=(1.75, y, 0.3), x_length=0.6, y_length=0.6, z_length=0.6), color="#b9c7d6")
    plotter.add_mesh(pv.Plane(i_size=80, j_size=80), color="#dfe4ea")
    plotter.add_light(pv.Light(position=(-3, -4, 8), light_type="scene light", intensity=0.85))
    plotter.add_light(pv.Light(light_type="headlight", intensity=0.5))
    plotter.camera_position = [(6.5, -9.5, 7), (0.8, 0.2, 1.6), (0, 0, 1)]

    plotter.exact_shadows.enable(intensity=0.85)
    plotter.exact_shadows.outlines(width=1.5, color="#20242a", creases=50)
    return plotter


if __name__ == "__main__":
    build().show()
