"""What the scenes of drop_in_pyvista.py are made of."""

import numpy as np
import pyvista as pv


def ball(**arguments):
    return pv.Sphere(radius=0.5, theta_resolution=24, phi_resolution=20, **arguments)


def table(plotter):
    return plotter.add_mesh(pv.Plane(center=(0, 0, -0.7), i_size=4, j_size=4), color="lightblue")


def scene(plotter, **arguments):
    """A ball over a table, under a lamp, and the ball as the arguments of add_mesh say."""
    arguments.setdefault("color", "tan")
    table(plotter)
    return plotter.add_mesh(ball(), **arguments)


def over_table(plotter, mesh, **arguments):
    table(plotter)
    return plotter.add_mesh(mesh, show_scalar_bar=False, **arguments)


def wavy():
    x, y = np.meshgrid(np.linspace(-2, 2, 30), np.linspace(-2, 2, 30))
    return pv.StructuredGrid(x, y, 0.3 * np.sin(2 * x) * np.cos(2 * y))


def numbered(mesh):
    mesh["height"] = np.asarray(mesh.points)[:, 2]
    return mesh


def cells(mesh):
    """Numbered by cells, not points."""
    mesh.cell_data["number"] = np.arange(mesh.n_cells)
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


def swirl():
    """A grid with the flow around an axis."""
    values = grid()
    points = np.asarray(values.points)
    values["flow"] = np.column_stack((-points[:, 1], points[:, 0], 0.3 + 0 * points[:, 2]))
    return values


def curve():
    return pv.Spline(np.array([(-1.0, 0, 0), (0, 0.4, 0.9), (1, 0, 0)]), 40)


def striped():
    colours = np.zeros((16, 16, 3), dtype=np.uint8)
    colours[::2, ::2] = (200, 60, 90)
    return pv.Texture(colours)


def turned():
    """A matrix that turns, moves and scales."""
    matrix = np.diag((1.0, 1.5, 0.8, 1.0))
    matrix[:2, :2] = [[0.6, -1.2], [0.8, 0.9]]
    matrix[:3, 3] = (0.3, -0.2, 0.2)
    return matrix
