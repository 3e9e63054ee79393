"""A scene drawn by the installed wheel through PyVista, without a display: its shadow, pixel by pixel, and its time."""

import time

started = time.perf_counter()

import numpy
import pyvista
import vtkshadow

WIDTH, HEIGHT, SCALE = 320, 240, 3.0  # pixels, and half the height of what is seen
PLATE = 1.0  # half its side
LEVEL = 1.0  # its height above the floor
LIGHT = numpy.array([0.37, -0.21, 4.0])
MOST_SECONDS = 2.0  # of the processor, as others may keep it busy


def make_plotter():
    plotter = pyvista.Plotter(off_screen=True, window_size=(WIDTH, HEIGHT), lighting="none")
    plotter.disable_anti_aliasing()  # a pixel is what its centre sees
    plotter.add_mesh(pyvista.Plane(i_size=20, j_size=20), color="white")
    plotter.add_mesh(pyvista.Plane(center=(0, 0, LEVEL), i_size=2 * PLATE, j_size=2 * PLATE), color="tomato")
    plotter.add_light(pyvista.Light(position=LIGHT, focal_point=(0, 0, 0), positional=True, cone_angle=180))
    plotter.camera_position = [(0, 0, 10), (0, 0, 0), (0, 1, 0)]
    plotter.camera.parallel_projection = True
    plotter.camera.parallel_scale = SCALE
    return plotter


def expected_shadow():
    """Rays from the light through the plate, down to the floor. Seen from above the plate hides what is below it."""
    step = 2 * SCALE / HEIGHT
    x, y = numpy.meshgrid(
        (numpy.arange(WIDTH) + 0.5 - WIDTH / 2) * step, (numpy.arange(HEIGHT) + 0.5 - HEIGHT / 2) * step
    )
    spread = (LIGHT[2] - LEVEL) / LIGHT[2]
    on_plate = [LIGHT[0] + (x - LIGHT[0]) * spread, LIGHT[1] + (y - LIGHT[1]) * spread]
    behind = numpy.maximum(*map(numpy.abs, on_plate)) < PLATE
    return behind & ~(numpy.maximum(abs(x), abs(y)) < PLATE)


def shadow_of(shadows):
    mask = pyvista.ImageData()
    assert shadows.GetShadowMask(0, mask), "there is no shadow mask"
    assert mask.dimensions[:2] == (WIDTH, HEIGHT), mask.dimensions
    return mask.active_scalars.reshape(HEIGHT, WIDTH) == 0


def main():
    plotter = make_plotter()
    shadows = vtkshadow.vtkShadowVolumePass()
    plotter.renderer.SetPass(shadows)
    plotter.render()
    picture = plotter.screenshot("wheel_scene.png", return_img=True)
    seconds, processor = time.perf_counter() - started, time.process_time()

    assert shadows.GetStatus() == shadows.STATUS_OK, shadows.GetStatusMessage()
    expected, found = expected_shadow(), shadow_of(shadows)
    assert expected.sum() > 1000, "the scene shows too little shadow"
    different = int((expected != found).sum())
    print(
        f"vtkshadow {vtkshadow.__version__}, {plotter.render_window.GetClassName()}: {int(found.sum())} pixels in shadow, "
        f"{int(expected.sum())} by calculation, {different} differ"
    )
    assert different == 0
    brightness = picture[::-1].sum(axis=2)
    assert brightness[found].max() < brightness[~found].min(), "the picture does not show the mask"
    print(
        f"{seconds:.2f} s from import to the first picture with shadows, {processor:.2f} s of processor time"
    )
    assert processor <= MOST_SECONDS


if __name__ == "__main__":
    main()
