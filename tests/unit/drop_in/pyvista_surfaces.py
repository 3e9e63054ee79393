"""Scenes of drop_in_pyvista.py: what there is to see in them."""

import numpy as np
import pyvista as pv

from pyvista_shapes import (ball, blocks, cells, cloud, curve, grid, numbered, over_table, scene, striped,
                            swirl, table, turned, wavy)


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
    scene(plotter)
    plotter.add_mesh(pv.Plane(center=(0, 0, 0.2)), texture=striped())


def textured_ball(plotter):
    over_table(plotter, ball().texture_map_to_sphere(inplace=False), texture=striped(), smooth_shading=True)


def coloured(plotter):
    mesh = ball()
    mesh["colours"] = (255 * (np.asarray(mesh.points) + 0.5)).astype(np.uint8)
    over_table(plotter, mesh, scalars="colours", rgb=True)


def holes(plotter):
    """Numbers that are none, too high and too low."""
    mesh = numbered(ball())
    mesh["height"][::7] = np.nan
    over_table(plotter, mesh, scalars="height", clim=(-0.2, 0.2), nan_color="black", above_color="red",
               below_color="blue")


def fading(plotter):
    mesh = numbered(ball())
    over_table(plotter, mesh, scalars="height", opacity=np.linspace(0, 1, mesh.n_points))


def categories(plotter):
    colours = pv.LookupTable("coolwarm", n_values=5, scalar_range=(0, 900))
    over_table(plotter, cells(ball()), scalars="number", cmap=colours)


def backfaces(plotter):
    over_table(plotter, ball().clip("x"), color="tan", backface_params={"color": "red"})


def rods(plotter):
    scene(plotter)
    ends = np.array([(-1.0, -1, 0), (1, -1, 0.5), (1, 1, 0), (-1, 1, 0.5)])
    plotter.add_lines(ends, color="purple", width=5)


def arrows(plotter):
    scene(plotter)
    plotter.add_arrows(np.array([(0, 0, 0.6), (1.0, 0, 0)]), np.array([(0, 0, 1.0), (0.5, 0.5, 0)]), mag=0.7)


def isolines(plotter):
    plotter.add_mesh(wavy(), color="white")
    plotter.add_mesh(numbered(wavy()).contour(8, scalars="height"), color="black", line_width=3)


def streams(plotter):
    lines = swirl().streamlines("flow", n_points=20, source_radius=0.4, source_center=(0, 0, 0))
    over_table(plotter, lines.tube(radius=0.03), color="orange")


def hedgehog(plotter):
    mesh = ball()
    mesh.compute_normals(inplace=True)
    over_table(plotter, mesh.glyph(orient="Normals", scale=False, factor=0.3, tolerance=0.1), color="green")


def placed(plotter):
    actor = scene(plotter)
    actor.SetPosition(0.5, 0.3, 0.4)
    actor.SetScale(1.2, 0.6, 0.8)
    actor.RotateX(40)


def shared_mesh(plotter):
    """One mesh drawn by several actors."""
    mesh = ball()
    table(plotter)
    for place in ((-1, 0, 0), (0, 1, 0.3), (1, 0, 0.6)):
        plotter.add_mesh(mesh, color="tan").position = place


def hidden(plotter):
    scene(plotter)
    plotter.add_mesh(pv.Cube(center=(1, 0, 0)), color="red").SetVisibility(False)
    plotter.add_mesh(pv.Cube(center=(-1, 0, 0)), color="red", name="gone")
    plotter.remove_actor("gone")


def nested(plotter):
    table(plotter)
    inner = pv.MultiBlock({"cone": pv.Cone(center=(0, 1, 0)), "none": None})
    _, mapper = plotter.add_composite(pv.MultiBlock([blocks(), inner]), color="tan")
    mapper.block_attr[2].visible = False
    mapper.block_attr[3].color = "red"
    mapper.block_attr[4].opacity = 0.5


def cut_by_mapper(plotter):
    scene(plotter).mapper.AddClippingPlane(pv.generate_plane((1, 1, 0), (0, 0, 0)))


def tubes(plotter):
    scene(plotter)
    plotter.add_mesh(curve(), line_width=8, render_lines_as_tubes=True, color="red")


def clipped(plotter):
    table(plotter)
    plotter.add_mesh(ball().clip("x"), color="tan")


def peeled(plotter):
    glass(plotter)
    plotter.disable_anti_aliasing()  # with multisampling it draws nothing
    plotter.enable_depth_peeling(8)


def glass(plotter):
    scene(plotter, opacity=0.5)
    plotter.add_mesh(pv.Cube(center=(0.3, 0.3, 0)), color="green", opacity=0.4)


def crowd(plotter):
    table(plotter)
    for index, place in enumerate(np.asarray(cloud().points)[:25]):
        plotter.add_mesh(pv.Sphere(radius=0.15, center=place, theta_resolution=9, phi_resolution=7),
                         color=(index / 25, 0.5, 0.4))


ROWS = {
    "smooth": lambda p: scene(p, smooth_shading=True, specular=0.5),
    "flat": lambda p: scene(p, smooth_shading=False),
    "gouraud": lambda p: scene(p, interpolation="Gouraud", ambient=0.2, diffuse=0.7, specular=1,
                               specular_power=20),
    "physically_based": lambda p: scene(p, pbr=True, metallic=0.6, roughness=0.4),
    "edges": lambda p: scene(p, show_edges=True),
    "wide_edges": lambda p: scene(p, show_edges=True, edge_color="red", line_width=3, edge_opacity=0.5),
    "vertices": lambda p: scene(p, show_vertices=True, vertex_color="red", point_size=7),
    "wireframe": lambda p: scene(p, style="wireframe", line_width=2),
    "wireframe_of_tubes": lambda p: scene(p, style="wireframe", line_width=5, render_lines_as_tubes=True),
    "points": lambda p: scene(p, style="points", point_size=6, render_points_as_spheres=True),
    "square_points": lambda p: p.add_points(np.asarray(ball().points), color="red", point_size=8),
    "gaussian_points": lambda p: over_table(p, cloud(), style="points_gaussian", point_size=15,
                                            emissive=True),
    "gaussian_spheres": lambda p: over_table(p, cloud(), style="points_gaussian", point_size=30,
                                             render_points_as_spheres=True),
    "unlit": lambda p: scene(p, lighting=False),
    "culled": lambda p: scene(p, culling="back"),
    "culled_front": lambda p: scene(p, culling="front"),
    "backface_colour": backfaces,
    "scalars": lambda p: p.add_mesh(numbered(wavy()), scalars="height", cmap="viridis"),
    "cell_scalars": lambda p: over_table(p, cells(ball()), scalars="number", cmap="jet", n_colors=8),
    "log_scale": lambda p: over_table(p, cells(ball()), scalars="number", log_scale=True, clim=(1, 900)),
    "lookup_table": categories,
    "out_of_range": holes,
    "rgb": coloured,
    "opacity_array": fading,
    "opacity_of_scalars": lambda p: over_table(p, numbered(ball()), scalars="height", opacity="sigmoid"),
    "terrain_edges": lambda p: p.add_mesh(numbered(wavy()), scalars="height", show_edges=True),
    "warped": lambda p: p.add_mesh(numbered(wavy()).warp_by_scalar("height", factor=2), smooth_shading=True),
    "sharp_edges": lambda p: over_table(p, pv.Cylinder(), split_sharp_edges=True, smooth_shading=True),
    "cloud": lambda p: p.add_mesh(cloud(), scalars="height", point_size=8),
    "crowd": crowd,
    "blocks": lambda p: p.add_mesh(blocks(), multi_colors=True),
    "blocks_composite": lambda p: p.add_composite(blocks(), color="tan"),
    "blocks_nested": nested,
    "volume": lambda p: (scene(p), p.add_volume(grid(), cmap="bone", opacity="linear")),
    "slices": lambda p: p.add_mesh(grid().slice_orthogonal()),
    "threshold": lambda p: over_table(p, grid().threshold(0.6), scalars="value"),
    "contours": lambda p: over_table(p, grid().contour(3), opacity=0.6),
    "isolines": isolines,
    "shrunk": lambda p: over_table(p, grid().extract_subset((0, 4, 0, 4, 0, 4)).shrink(0.7), color="tan"),
    "explicit_cells": lambda p: over_table(p, grid().cast_to_unstructured_grid().clip("x"), show_edges=True),
    "extracted_edges": lambda p: over_table(p, pv.Cube().extract_feature_edges(30), color="red",
                                            line_width=4),
    "moebius_strip": lambda p: over_table(p, pv.ParametricMobius().scale(0.6, inplace=False), color="tan"),
    "text_3d": lambda p: over_table(p, pv.Text3D("solid", depth=0.2, height=0.8), color="tan"),
    "streamlines": streams,
    "glyphs": glyphs,
    "hedgehog": hedgehog,
    "arrows": arrows,
    "lines": rods,
    "picture": pictures,
    "texture": textured,
    "texture_ball": textured_ball,
    "user_matrix": lambda p: setattr(scene(p), "user_matrix", turned()),
    "placed": placed,
    "shared_mesh": shared_mesh,
    "hidden": hidden,
    "glass": glass,
    "depth_peeling": peeled,
    "tubes": tubes,
    "clipped": clipped,
    "clipped_by_mapper": cut_by_mapper,
}
