"""PyVista without a display, after `import vtkshadow.headless`. Usage: headless_pyvista.py osmesa|egl|unset"""

import ctypes
import importlib.util
import os
import sys
import tempfile
import warnings

BACKEND = sys.argv[1]
LIBRARY = {"osmesa": "libOSMesa.so.8", "egl": "libEGL.so.1"}.get(BACKEND)
if importlib.util.find_spec("pyvista") is None:
    print("there is no PyVista to test")
    sys.exit(0)
if LIBRARY is not None:
    try:
        ctypes.CDLL(LIBRARY)
    except OSError as error:
        print(f"there is no {LIBRARY} to test: {error}")
        sys.exit(0)
os.environ["VTKSHADOW_HEADLESS"] = "" if BACKEND == "unset" else BACKEND

import vtkshadow.headless
import numpy as np
import pyvista as pv
from vtkshadow import vtkShadowVolumePass

warnings.simplefilter("error")  # that PyVista will likely crash
SIZE = (200, 150)
# With PyVista 0.44 a plotter that was closed and collected now and then changes camera or lighting of a later one's parts,
# on a display and without us as well.
KEPT = []


def make_plotter(off_screen, shape, shadows):
    """In each part a ball over a table, and in the right ones a red one."""
    plotter = pv.Plotter(off_screen=off_screen, shape=shape, window_size=SIZE, lighting="none", border=False)
    for row in range(shape[0]):
        for column in range(shape[1]):
            plotter.subplot(row, column)
            plotter.add_mesh(pv.Sphere(center=(0, 0, 1)), color="red" if column else "tan")
            plotter.add_mesh(pv.Plane(i_size=4, j_size=4), color="lightblue")
            plotter.add_light(pv.Light(position=(1, 1, 4), positional=True, cone_angle=180), only_active=True)
            if shadows:
                plotter.renderer.SetPass(vtkShadowVolumePass())
    KEPT.append(plotter)
    return plotter


def expect(right, what):
    if not right:
        sys.exit("FAILED: " + what)


def count_black(picture):
    """Unlit: the lower half of the ball, and with the pass its shadow."""
    return int((picture.max(axis=2) < 3).sum())


def pictures_of(plotter, what):
    """All ways to a picture give the same one, also after the end."""
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "picture.png")
        shown = plotter.show(return_img=True, screenshot=file, auto_close=False)
        expect(os.path.getsize(file) > 0, what + ": no file")
    again = plotter.screenshot(return_img=True)
    expect(shown.shape == (SIZE[1], SIZE[0], 3), f"{what}: {shown.shape}")
    # VTK's way to a picture turns the camera by less than a digit.
    expect(np.abs(shown.astype(int) - again).max() <= 2, what + ": the second picture is another")
    plotter.close()
    expect(np.abs(plotter.screenshot(return_img=True).astype(int) - again).max() <= 2, what + ": another when closed")
    return shown


def main():
    for shape in (1, 1), (1, 2):
        for off_screen in True, False:
            what = f"off_screen={off_screen}, shape={shape}"
            plain = pictures_of(make_plotter(off_screen, shape, False), what)
            shadowed = pictures_of(make_plotter(off_screen, shape, True), what + ", shadows")
            expect(count_black(shadowed) > 1.5 * count_black(plain) > 0, what + ": no shadow")
            changed = np.any(plain != shadowed, axis=2).mean()
            expect(0.002 < changed < 0.1, f"{what}: the pass changed {changed:.1%} of the picture")
            red = np.all(plain[:, :, 1:] < 50, axis=2) & (plain[:, :, 0] > 100)
            expect(red[:, : SIZE[0] // 2].sum() == 0, what + ": the left part shows the right one")
            expect((red[:, SIZE[0] // 2 :].sum() > 20) == (shape == (1, 2)), what + ": the right part")

    # Several at a time, in turns, and one that ends between.
    first, second = (make_plotter(True, (1, 1), shadows) for shadows in (False, True))
    before = first.screenshot(return_img=True), second.screenshot(return_img=True)
    third = make_plotter(True, (1, 2), True)
    third.screenshot(return_img=True)
    third.close()
    for plotter, picture in zip((first, second), before):
        plotter.render()
        expect(np.array_equal(plotter.screenshot(return_img=True), picture), "a picture changed with another plotter")
    expect(not np.array_equal(*before), "two plotters with one picture")
    pv.close_all()
    expect(pv.Sphere().plot(off_screen=True, return_img=True, window_size=SIZE).std() > 10, "plot()")


main()
