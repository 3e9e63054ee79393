"""Scenes as PyVista's users make them look the same with our passes as without, where these have nothing to add.

Needs PyVista and a display. Usage: drop_in_pyvista.py [-v] [TestPyVista.test_NAME]
"""

import sys
import unittest

try:
    import numpy as np
    import pyvista as pv
except ImportError as error:
    print(f"there is no PyVista: {error}")
    sys.exit(0)

from vtkshadow import vtkShadowVolumePass, vtkSilhouettePass

SIZE = (240, 180)


def ball(**arguments):
    return pv.Sphere(radius=0.5, theta_resolution=24, phi_resolution=20, **arguments)


def scene(plotter, **arguments):
    """A ball over a table, under a lamp, and the ball as the arguments of add_mesh say."""
    arguments.setdefault("color", "tan")
    plotter.add_mesh(pv.Plane(center=(0, 0, -0.7), i_size=4, j_size=4), color="lightblue")
    return plotter.add_mesh(ball(), **arguments)


def wavy():
    x, y = np.meshgrid(np.linspace(-2, 2, 30), np.linspace(-2, 2, 30))
    return pv.StructuredGrid(x, y, 0.3 * np.sin(2 * x) * np.cos(2 * y))


def numbered(mesh):
    mesh["height"] = np.asarray(mesh.points)[:, 2]
    return mesh


def cloud():
    random = np.random.default_rng(3)
    return numbered(pv.PolyData(random.normal(size=(60, 3)) * 0.5))


def blocks():
    return pv.MultiBlock([ball(), pv.Cube(center=(1.2, 0, 0)), pv.Cone(center=(-1.2, 0, 0))])


def grid():
    values = pv.ImageData(dimensions=(12, 12, 12), spacing=(0.1, 0.1, 0.1), origin=(-0.6, -0.6, -0.6))
    values["value"] = np.linalg.norm(np.asarray(values.points), axis=1)
    return values


def glyphs(plotter):
    points = cloud()
    points["direction"] = np.asarray(points.points)
    scene(plotter)
    plotter.add_mesh(points.glyph(orient="direction", scale=False, factor=0.3), color="red")


def pictures(plotter):
    image = pv.ImageData(dimensions=(8, 8, 1), spacing=(0.2, 0.2, 1))
    image["value"] = np.arange(64.0)
    scene(plotter)
    plotter.add_mesh(image, scalars="value", show_scalar_bar=False)


def textured(plotter):
    colours = np.zeros((16, 16, 3), dtype=np.uint8)
    colours[::2, ::2] = (200, 60, 90)
    mesh = pv.Plane(center=(0, 0, 0.2))
    scene(plotter)
    plotter.add_mesh(mesh, texture=pv.Texture(colours))


def lamps(plotter):
    scene(plotter)
    plotter.remove_all_lights()
    plotter.add_light(pv.Light(position=(2, 2, 4), positional=True, cone_angle=30, exponent=5))
    plotter.add_light(pv.Light(position=(-3, 1, 3), color="orange", light_type="scene light"))


def outlined(plotter):
    scene(plotter)
    plotter.add_silhouette(ball(), color="red", line_width=4)


def labels(plotter):
    scene(plotter)
    plotter.add_point_labels([(0, 0, 0.8), (1, 0, 0)], ["above", "beside"])


def layered_text(plotter):
    scene(plotter)
    plotter.add_text("a title", font_size=12)
    plotter.add_legend([["ball", "tan"], ["table", "lightblue"]])


def framed(plotter):
    scene(plotter)
    plotter.show_bounds(grid="front", location="outer")


def charted(plotter):
    scene(plotter)
    chart = pv.Chart2D(size=(0.4, 0.4), loc=(0.5, 0.5))
    chart.line([0, 1, 2], [0, 3, 1])
    plotter.add_chart(chart)


def with_axes(plotter):
    scene(plotter)
    plotter.add_axes()
    plotter.add_axes_at_origin()


def peeled(plotter):
    scene(plotter, opacity=0.5)
    plotter.add_mesh(pv.Cube(center=(0.3, 0.3, 0)), color="green", opacity=0.4)
    plotter.enable_depth_peeling(8)


def glass(plotter):
    scene(plotter, opacity=0.5)
    plotter.add_mesh(pv.Cube(center=(0.3, 0.3, 0)), color="green", opacity=0.4)


def occluded(plotter):
    scene(plotter)
    plotter.renderer.UseSSAOOn()
    plotter.renderer.SetSSAORadius(0.5)


def smoothed(plotter):
    scene(plotter)
    plotter.disable_anti_aliasing()
    plotter.renderer.UseFXAAOn()  # enable_anti_aliasing("fxaa") sets another pass where there is no display


def hidden_lines(plotter):
    scene(plotter, style="wireframe", color="black")
    plotter.enable_hidden_line_removal()


def parallel(plotter):
    scene(plotter)
    plotter.enable_parallel_projection()


def gradient(plotter):
    scene(plotter)
    plotter.set_background("white", top="navy")


def floor(plotter):
    scene(plotter)
    plotter.add_floor("-z")


def tubes(plotter):
    scene(plotter)
    line = pv.Spline(np.array([(-1.0, 0, 0), (0, 0.4, 0.9), (1, 0, 0)]), 40)
    plotter.add_mesh(line, line_width=8, render_lines_as_tubes=True, color="red")


def clipped(plotter):
    plotter.add_mesh(pv.Plane(center=(0, 0, -0.7), i_size=4, j_size=4))
    plotter.add_mesh(ball().clip("x"), color="tan")


ROWS = {
    "smooth": lambda p: scene(p, smooth_shading=True, specular=0.5),
    "flat": lambda p: scene(p, smooth_shading=False),
    "physically_based": lambda p: scene(p, pbr=True, metallic=0.6, roughness=0.4),
    "edges": lambda p: scene(p, show_edges=True),
    "wireframe": lambda p: scene(p, style="wireframe", line_width=2),
    "points": lambda p: scene(p, style="points", point_size=6, render_points_as_spheres=True),
    "unlit": lambda p: scene(p, lighting=False),
    "culled": lambda p: scene(p, culling="back"),
    "scalars": lambda p: p.add_mesh(numbered(wavy()), scalars="height", cmap="viridis"),
    "terrain_edges": lambda p: p.add_mesh(numbered(wavy()), scalars="height", show_edges=True),
    "cloud": lambda p: p.add_mesh(cloud(), scalars="height", point_size=8),
    "blocks": lambda p: p.add_mesh(blocks(), multi_colors=True),
    "blocks_composite": lambda p: p.add_composite(blocks(), color="tan"),
    "volume": lambda p: (scene(p), p.add_volume(grid(), cmap="bone", opacity="linear")),
    "slices": lambda p: p.add_mesh(grid().slice_orthogonal()),
    "glyphs": glyphs,
    "picture": pictures,
    "texture": textured,
    "lamps": lamps,
    "silhouette": outlined,
    "labels": labels,
    "text_and_legend": layered_text,
    "bounds": framed,
    "chart": charted,
    "axes": with_axes,
    "glass": glass,
    "depth_peeling": peeled,
    "ssao": occluded,
    "fxaa": smoothed,
    "hidden_lines": hidden_lines,
    "parallel": parallel,
    "gradient": gradient,
    "floor": floor,
    "tubes": tubes,
    "clipped": clipped,
}


def draw(build, make_pass):
    """Two pictures of a scene: RGBA, and one with a transparent background."""
    plotter = pv.Plotter(off_screen=True, window_size=SIZE)
    build(plotter)
    plotter.camera_position = [(4, -5, 3.5), (0, 0, 0), (0, 0, 1)]
    plotter.camera.clipping_range = (0.1, 30)
    plotter.render()
    if make_pass is not None:
        plotter.renderer.SetPass(make_pass())
        plotter.render()
    found = [plotter.screenshot(None, return_img=True), plotter.screenshot(None, True, return_img=True)]
    plotter.close()
    return found


def shadows_of_nothing():
    shadows = vtkShadowVolumePass()
    shadows.SetShadowIntensity(0)
    return shadows


def no_lines():
    outlines = vtkSilhouettePass()
    outlines.SilhouetteEdgesOff()
    outlines.BorderEdgesOff()
    return outlines


class TestPyVista(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # An X server may start anew when its last window goes, and refuse the next one meanwhile.
        cls.window_that_stays = pv.Plotter(off_screen=True, window_size=(20, 20))
        cls.window_that_stays.render()

    @classmethod
    def tearDownClass(cls):
        cls.window_that_stays.close()

    def check(self, build):
        plain = draw(build, None)
        seen = (plain[0] != plain[0][0, 0]).any(axis=2).sum()
        self.assertGreater(int(seen), 1000, "there is nothing to see")
        for make_pass in (shadows_of_nothing, no_lines):
            for ours, theirs in zip(draw(build, make_pass), plain):
                self.assertEqual(ours.shape, theirs.shape)
                self.assertEqual(int((ours != theirs).any(axis=2).sum()), 0, make_pass.__name__)


for name, build in ROWS.items():
    setattr(TestPyVista, f"test_{name}", lambda self, build=build: self.check(build))


if __name__ == "__main__":
    unittest.main()
