"""A machine part: shadows, and lines along silhouettes and creases, as on a drawing."""

import without_display  # noqa: F401
import numpy as np
import pyvista as pv
import vtkshadow.pyvista  # noqa: F401


def arc(center, radius, start=0, end=360):
    angles = np.radians(np.linspace(start, end, 48, endpoint=end - start < 360))
    return np.column_stack([center[0] + radius * np.cos(angles), center[1] + radius * np.sin(angles), 0 * angles])


def plate(outline, holes, thickness):
    """A plate with round holes: a flat mesh between closed lines, extruded."""
    loops = [outline, *(arc(center, radius)[::-1] for center, radius in holes)]
    first = np.cumsum([0, *map(len, loops)])
    faces = np.concatenate([[len(loop), *range(start, start + len(loop))] for loop, start in zip(loops, first)])
    edges = pv.PolyData(np.vstack(loops), faces)
    return edges.delaunay_2d(edge_source=edges).extrude((0, 0, thickness), capping=True)


def bracket():
    corners = [arc((x, y), 0.4, start, start + 90) for x, y, start in [(2, 1.4, 0), (-2, 1.4, 90), (-2, -1.4, 180),
                                                                       (2, -1.4, 270)]]
    base = plate(np.vstack(corners), [((x, y), 0.25) for x in (-1.9, 1.9) for y in (-1.3, 1.3)], 0.35)
    ear = plate(np.vstack([arc((0, 2), 0.9, 0, 180), [[-0.9, 0, 0], [0.9, 0, 0]]]), [((0, 2), 0.5)], 0.35)
    rib = plate(np.array([[0, 0, 0], [0.75, 0, 0], [0, 1.2, 0]]), [], 0.2)
    parts = [base]
    for side in (-0.8, 0.8):
        upright = ear.rotate_x(90).translate((0, side + 0.175, 0.35))
        outside = 1 if side > 0 else -1
        parts += [upright, rib.rotate_x(90).rotate_z(90 * outside).translate(
            (0.1 * outside, side + outside * 0.175, 0.35))]
    pin = pv.Cylinder(center=(0, 0, 2.35), direction=(0, 1, 0), radius=0.47, height=3, resolution=64)
    return parts, pin.triangulate()


def build(**options):
    plotter = pv.Plotter(lighting="none", **options)
    plotter.set_background("#eef1f4")
    parts, pin = bracket()
    for part in parts:
        plotter.add_mesh(part, color="#7f9fbf", specular=0.2)
    plotter.add_mesh(pin, color="#d9a441", specular=0.4)
    plotter.add_mesh(pv.Plane(i_size=60, j_size=60), color="#eef1f4")
    plotter.add_light(pv.Light(position=(-4, -5, 8), light_type="scene light", intensity=0.85))
    plotter.add_light(pv.Light(light_type="headlight", intensity=0.5))
    plotter.camera_position = [(6.5, -8, 6.5), (0.5, 0, 0.9), (0, 0, 1)]

    plotter.exact_shadows.enable(intensity=0.8)
    plotter.exact_shadows.outlines(width=2, creases=30)
    return plotter


if __name__ == "__main__":
    build().show()
