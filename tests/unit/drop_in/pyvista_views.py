"""Scenes of drop_in_pyvista.py: how they are looked at and lit, and what is drawn over and behind them."""

import numpy as np
import pyvista as pv

from pyvista_shapes import ball, grid, numbered, scene, striped


def lamps(plotter):
    scene(plotter)
    plotter.remove_all_lights()
    plotter.add_light(pv.Light(position=(2, 2, 4), positional=True, cone_angle=30, exponent=5))
    plotter.add_light(pv.Light(position=(-3, 1, 3), color="orange", light_type="scene light"))


def lit_by(*arguments, **smooth):
    """A scene with only the lights made of the arguments."""
    def build(plotter):
        scene(plotter, **smooth)
        plotter.remove_all_lights()
        for each in arguments:
            plotter.add_light(pv.Light(**each))
    return build


def shown_lamp(plotter):
    scene(plotter)
    plotter.add_light(pv.Light(position=(1, 0.5, 2), positional=True, cone_angle=40, show_actor=True))


def three_lights(plotter):
    plotter.enable_3_lights()
    scene(plotter)


def light_off(plotter):
    scene(plotter)
    for light in plotter.renderer.lights[1:]:
        light.switch_off()


def outlined(plotter):
    scene(plotter)
    plotter.add_silhouette(ball(), color="red", line_width=4)


def labels(plotter):
    scene(plotter)
    plotter.add_point_labels([(0, 0, 0.8), (1, 0, 0)], ["above", "beside"])


def plain_labels(plotter):
    scene(plotter)
    plotter.add_point_labels([(0, 0, 0.8), (1, 0, 0)], ["above", "beside"], shape=None, always_visible=True,
                             render_points_as_spheres=True, point_size=12, point_color="red")


def layered_text(plotter):
    scene(plotter)
    plotter.add_text("a title", font_size=12)
    plotter.add_legend([["ball", "tan"], ["table", "lightblue"]])


def framed(plotter):
    scene(plotter)
    plotter.show_bounds(grid="front", location="outer")


def boxed(plotter):
    scene(plotter)
    plotter.add_bounding_box(color="red", line_width=3)
    plotter.add_bounding_box(color="white", culling="front", outline=False, opacity=0.3)


def charted(plotter):
    scene(plotter)
    chart = pv.Chart2D(size=(0.4, 0.4), loc=(0.5, 0.5))
    chart.line([0, 1, 2], [0, 3, 1])
    plotter.add_chart(chart)


def with_axes(plotter):
    scene(plotter)
    plotter.add_axes()
    plotter.add_axes_at_origin()


def bars(plotter):
    scene(plotter)
    plotter.add_mesh(numbered(pv.Cube(center=(1, 0, 0))), scalars="height",
                     scalar_bar_args={"vertical": True, "title": "height"})
    plotter.add_scalar_bar("again", n_labels=3)


def measured(plotter):
    scene(plotter)
    plotter.add_ruler((-1, -1, -0.7), (1, -1, -0.7), title="width")
    plotter.add_legend_scale()


def controls(plotter):
    scene(plotter)
    plotter.add_slider_widget(lambda value: None, (0, 1), title="slider")
    plotter.add_checkbox_button_widget(lambda on: None, value=True)


def handles(plotter):
    scene(plotter)
    plotter.add_line_widget(lambda line: None, bounds=(-1, 1, -1, 1, -0.5, 0.5))
    plotter.add_sphere_widget(lambda centre: None, center=(1, 1, 0), radius=0.2)


def clip_widget(plotter):
    plotter.add_mesh(pv.Plane(center=(0, 0, -0.7), i_size=4, j_size=4))
    plotter.add_mesh_clip_plane(ball(), color="tan")


def pickable(plotter):
    scene(plotter)
    plotter.enable_mesh_picking(show_message=True)


def subplots(plotter):
    for column, colour in enumerate(("tan", "red")):
        plotter.subplot(0, column)
        scene(plotter, color=colour)
        plotter.add_text(colour, font_size=6)
    plotter.link_views()


def behind(plotter):
    from pyvista import examples

    scene(plotter)
    plotter.add_background_image(examples.mapfile)


def environment(plotter):
    colours = np.zeros((32, 64, 3), dtype=np.uint8)
    colours[:16] = (90, 120, 200)
    colours[16:] = (80, 70, 30)
    sky = pv.Texture(colours)
    sky.MipmapOn()
    sky.InterpolateOn()
    plotter.set_environment_texture(sky)
    scene(plotter, pbr=True, metallic=0.8, roughness=0.3)


def skybox(plotter):
    image = striped().to_image()
    sky = pv.Texture()
    sky.SetCubeMap(True)
    for face in range(6):
        sky.SetInputDataObject(face, image)
    sky.MipmapOn()
    sky.InterpolateOn()
    scene(plotter)
    plotter.add_actor(sky.to_skybox())


def with_call(name, *arguments, **named):
    """The scene, and a call of the plotter's."""
    def build(plotter):
        scene(plotter)
        getattr(plotter, name)(*arguments, **named)
    return build


def occluded(plotter):
    scene(plotter)
    plotter.renderer.UseSSAOOn()
    plotter.renderer.SetSSAORadius(0.5)


def hidden_lines(plotter):
    scene(plotter, style="wireframe", color="black")
    plotter.enable_hidden_line_removal()


def parallel(plotter):
    scene(plotter)
    plotter.enable_parallel_projection()
    plotter.parallel_scale = 2


def close_up(plotter):
    scene(plotter)
    plotter.camera_position = [(0.9, -1.1, 0.3), (0, 0, 0), (0.1, 0, 1)]
    plotter.camera.view_angle = 70
    plotter.camera.clipping_range = (0.05, 20)


def within(plotter):
    """The eye is in a shadow, and in a room with a lamp."""
    plotter.add_mesh(pv.Cube(x_length=8, y_length=8, z_length=8), color="white")
    plotter.remove_all_lights()
    plotter.add_light(pv.Light(position=(0.5, -0.5, 3), positional=True, cone_angle=180))
    plotter.add_light(pv.Light(light_type="headlight", intensity=0.2))
    scene(plotter)
    plotter.camera_position = [(-0.1, -0.2, -0.62), (-2, 2, -0.7), (0, 0, 1)]
    plotter.camera.view_angle = 80
    plotter.camera.clipping_range = (0.01, 20)


def orbited(plotter):
    scene(plotter)
    path = plotter.generate_orbital_path(factor=2.0, n_points=5, shift=1.0)
    plotter.camera_position = [tuple(path.points[2]), (0, 0, 0), (0, 0, 1)]
    plotter.camera.clipping_range = (0.1, 60)


ROWS = {
    "lamps": lamps,
    "lamp_all_round": lit_by({"position": (1, 1, 2), "positional": True, "cone_angle": 180,
                              "attenuation_values": (0, 0.5, 0)}, smooth_shading=True),
    "camera_light": lit_by({"position": (1, 1, 0.5), "light_type": "camera light"}),
    "headlight": lit_by({"light_type": "headlight"}),
    "lamp_actor": shown_lamp,
    "no_light": lit_by(),
    "three_lights": three_lights,
    "light_off": light_off,
    "silhouette": outlined,
    "labels": labels,
    "labels_always_visible": plain_labels,
    "text_and_legend": layered_text,
    "title": with_call("add_title", "a title", font_size=8),
    "bounds": framed,
    "grid": with_call("show_grid"),
    "bounding_box": boxed,
    "chart": charted,
    "axes": with_axes,
    "box_axes": with_call("add_box_axes"),
    "north_arrow": with_call("add_north_arrow_widget"),
    "orientation_widget": with_call("add_camera_orientation_widget"),
    "scalar_bars": bars,
    "ruler": measured,
    "logo": with_call("add_logo_widget"),
    "sliders": controls,
    "handles": handles,
    "plane_widget": with_call("add_plane_widget", lambda normal, origin: None,
                              bounds=(-1, 1, -1, 1, -0.6, 1)),
    "clip_widget": clip_widget,
    "threshold_widget": lambda p: (scene(p), p.add_mesh_threshold(grid(), scalars="value")),
    "picking": pickable,
    "subplots": subplots,
    "background_image": behind,
    "gradient": with_call("set_background", "white", top="navy"),
    "environment": environment,
    "skybox": skybox,
    "ssao": occluded,
    "ssao_pass": with_call("enable_ssao", radius=0.3, kernel_size=16),
    "eye_dome": with_call("enable_eye_dome_lighting"),
    "depth_of_field": with_call("enable_depth_of_field"),
    "blur": with_call("add_blurring"),
    "fxaa": with_call("enable_anti_aliasing", "fxaa"),
    "msaa": with_call("enable_anti_aliasing", "msaa", multi_samples=8),
    "ssaa": with_call("enable_anti_aliasing", "ssaa"),
    "no_aa": with_call("disable_anti_aliasing"),
    "hidden_lines": hidden_lines,
    "parallel": parallel,
    "stereo": with_call("enable_stereo_render"),
    "scaled": with_call("set_scale", zscale=1.5),
    "close_up": close_up,
    "in_a_room": within,
    "orbit": orbited,
    "floor": with_call("add_floor", "-z", offset=0.3),
    "lit_floor": with_call("add_floor", "-z", lighting=True, offset=0.3, pad=1.0),
}
