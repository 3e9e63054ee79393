"""VTK's own classes without a display, after `import vtkshadow.headless`. Usage: headless_plain.py osmesa|egl|unset"""

import ctypes
import importlib
import os
import sys

BACKEND = sys.argv[1]
LIBRARY = {"osmesa": "libOSMesa.so.8", "egl": "libEGL.so.1"}.get(BACKEND)
if LIBRARY is not None:
    try:
        ctypes.CDLL(LIBRARY)
    except OSError as error:
        print(f"there is no {LIBRARY} to test: {error}")
        sys.exit(0)
os.environ["VTKSHADOW_HEADLESS"] = "" if BACKEND == "unset" else BACKEND

import vtkshadow.headless
from vtkshadow import vtkShadowVolumePass
from vtkshadow._build import VTK_PACKAGE

# Whatever it is called: there may be another VTK beside the one that the package is for.
for module in "vtkInteractionStyle", "vtkRenderingOpenGL2", "vtkRenderingUI":
    importlib.import_module(f"{VTK_PACKAGE}.{module}")
sources, core = (importlib.import_module(f"{VTK_PACKAGE}.{name}") for name in ("vtkFiltersSources", "vtkRenderingCore"))

SIZE = (120, 100)
BACKGROUND = (51, 102, 153)
CUBE = (255, 128, 0)


def make_window():
    """A cube, drawn without light, that fills the middle of the window."""
    source = sources.vtkCubeSource()
    mapper = core.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = core.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*(value / 255 for value in CUBE))
    actor.GetProperty().LightingOff()
    renderer = core.vtkRenderer()
    renderer.SetBackground(*(value / 255 for value in BACKGROUND))
    renderer.AddActor(actor)
    renderer.GetActiveCamera().SetPosition(0, 0, 4)
    window = core.vtkRenderWindow()
    window.SetSize(*SIZE)
    window.SetMultiSamples(0)
    window.AddRenderer(renderer)
    return window, renderer


def expect_cube(window, what):
    """The middle is cube and the rim is background, whichever buffer is read, and there are no other colours."""
    for front in True, False:
        taken = core.vtkWindowToImageFilter()
        taken.SetInput(window)
        taken.SetReadFrontBuffer(front)
        taken.Update()
        values = taken.GetOutput().GetPointData().GetScalars()
        colours = [tuple(int(value) for value in values.GetTuple(i)) for i in range(values.GetNumberOfTuples())]
        middle = colours[SIZE[0] * (SIZE[1] // 2) + SIZE[0] // 2]
        if len(colours) != SIZE[0] * SIZE[1] or set(colours) != {CUBE, BACKGROUND}:
            sys.exit(f"FAILED: {what}: {len(colours)} pixels of the colours {set(colours)}")
        if middle != CUBE or set(colours[: SIZE[0]]) != {BACKGROUND}:
            sys.exit(f"FAILED: {what}: {middle} in the middle")


def main():
    first, renderer = make_window()
    expect_cube(first, "plain " + first.GetClassName())

    second, _ = make_window()
    interactor = core.vtkRenderWindowInteractor()
    interactor.SetRenderWindow(second)
    interactor.Initialize()
    interactor.Start()
    expect_cube(second, "with an interactor")
    interactor.TerminateApp()
    second.Finalize()
    expect_cube(second, "after Finalize()")
    del interactor, second

    renderer.SetPass(vtkShadowVolumePass())
    expect_cube(first, "with the shadow pass, after another window's end")

    ours = vtkshadow.vtkHeadlessRenderWindow()
    ours.SetSize(*SIZE)
    first.RemoveRenderer(renderer)
    ours.AddRenderer(renderer)
    expect_cube(ours, "vtkHeadlessRenderWindow")
    del first
    expect_cube(ours, "vtkHeadlessRenderWindow, after VTK's window's end")


main()
