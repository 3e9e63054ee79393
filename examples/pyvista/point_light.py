"""A lantern: a point light within a cage throws the cage's shadow in all directions."""

import without_display  # noqa: F401
import pyvista as pv
import vtkshadow.pyvista  # noqa: F401


def cage(radius=0.55):
    """Rings and bars around a ball."""
    for angle in range(0, 180, 30):
        ring = pv.Disc(inner=radius - 0.03, outer=radius + 0.03, c_res=72).extrude((0, 0, 0.05), capping=True)
        yield ring.translate((0, 0, -0.025)).rotate_x(90).rotate_z(angle)
    yield pv.ParametricTorus(ringradius=radius, crosssectionradius=0.035)
    yield pv.Cylinder(center=(0, 0, 1.4), direction=(0, 0, 1), radius=0.02, height=1.7, resolution=24)


def build(**options):
    plotter = pv.Plotter(lighting="none", **options)
    plotter.set_background("black")
    for mesh in cage():
        plotter.add_mesh(mesh, color="#8c6b3f", specular=0.3)
    bulb = plotter.add_mesh(pv.Sphere(radius=0.12), color="#fff3c9", lighting=False)
    for x, y, height in [(-1.9, 0.7, 1.2), (1.6, 1.9, 1.6), (1.2, -1.5, 0.8), (-1.1, -1.4, 0.5)]:
        column = pv.Cylinder(center=(x, y, height / 2 - 1.2), direction=(0, 0, 1), radius=0.22, height=height)
        plotter.add_mesh(column, color="#a9bfb5", smooth_shading=True, split_sharp_edges=True)
    for center, normal in [((0, 0, -1.2), (0, 0, 1)), ((0, 3, 1), (0, -1, 0)), ((-3.2, 0, 1), (1, 0, 0))]:
        plotter.add_mesh(pv.Plane(center=center, direction=normal, i_size=9, j_size=9), color="#cdb79a")
    lamp = pv.Light(position=(0, 0, 0), color="#ffe2b0", light_type="scene light", intensity=1.0)
    lamp.positional = True
    lamp.cone_angle = 180  # a point light: it shines to all sides
    plotter.add_light(lamp)
    plotter.add_light(pv.Light(light_type="headlight", color="#8090c0", intensity=0.15))
    plotter.camera_position = [(3.8, -6.0, 2.8), (-0.3, 0.4, 0.1), (0, 0, 1)]

    plotter.exact_shadows.enable()
    plotter.exact_shadows.shadow_pass.SetCasting(bulb, False)  # the light is within it
    return plotter


if __name__ == "__main__":
    build().show()
