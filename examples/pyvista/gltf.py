"""A glTF file with lights of its own: they come with the scene, and cast."""

import json
import pathlib
import tempfile

import without_display  # noqa: F401
import pyvista as pv
import vtkshadow.pyvista  # noqa: F401

LAMPS = [((-1.6, 2.2, 1.4), (1.0, 0.72, 0.42)), ((1.8, 1.7, 1.2), (0.45, 0.62, 1.0))]  # place and colour


def write_scene(path):
    """What a modelling program does: an arcade, in metres with y upwards, as glTF with KHR_lights_punctual."""
    plotter = pv.Plotter(off_screen=True)
    stone = {"color": "#e6dac6", "smooth_shading": True, "split_sharp_edges": True}
    plotter.add_mesh(pv.Box((-4, 4, -0.2, 0, -3, 3)), **stone)
    plotter.add_mesh(pv.Box((-4, 4, 0, 3.4, -3.2, -3)), **stone)
    for x in (-2.4, -0.8, 0.8, 2.4):
        shaft = pv.Cylinder(center=(x, 1.1, -0.3), direction=(0, 1, 0), radius=0.2, height=2.2, resolution=80)
        plotter.add_mesh(shaft.triangulate(), **stone)
        for y in (0.06, 2.14):
            plotter.add_mesh(pv.Box((x - 0.3, x + 0.3, y - 0.06, y + 0.06, -0.6, 0)), **stone)
    plotter.add_mesh(pv.Box((-3, 3, 2.2, 2.5, -0.6, 0.0)), **stone)
    plotter.add_mesh(pv.Sphere(radius=0.4, center=(0, 0.4, 1.0), theta_resolution=60, phi_resolution=60), color="#b5553c", smooth_shading=True)
    plotter.export_gltf(path, rotate_scene=False)
    plotter.close()

    scene = json.loads(pathlib.Path(path).read_text())
    scene["extensionsUsed"] = ["KHR_lights_punctual"]
    scene["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"type": "point", "color": color, "intensity": 1.5} for _, color in LAMPS]}}
    for number, (place, _) in enumerate(LAMPS):
        scene["scenes"][0]["nodes"].append(len(scene["nodes"]))
        scene["nodes"].append({"translation": place, "extensions": {"KHR_lights_punctual": {"light": number}}})
    pathlib.Path(path).write_text(json.dumps(scene))


def build(**options):
    plotter = pv.Plotter(lighting="none", **options)
    plotter.set_background("#1a1c22")
    with tempfile.TemporaryDirectory() as folder:
        write_scene(f"{folder}/arcade.gltf")
        plotter.import_gltf(f"{folder}/arcade.gltf")
    plotter.add_light(pv.Light(light_type="headlight", intensity=0.15))
    plotter.camera_position = [(3.2, 3.6, 8.2), (0, 1.0, -0.8), (0, 1, 0)]

    plotter.exact_shadows.enable()
    return plotter


if __name__ == "__main__":
    build().show()
