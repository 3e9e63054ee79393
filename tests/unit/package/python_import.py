"""The installed Python package, seen from outside: python_import.py CASE, a function below."""

import ctypes
import ctypes.util
import importlib
import os
import subprocess
import sys
import tempfile


def fail(message):
    sys.exit("FAILED: " + message)


def expect_import_error(words):
    """However often it is tried."""
    for _ in range(2):
        try:
            import vtkshadow.headless
        except ImportError as error:
            if not all(word in str(error) for word in words):
                fail("the ImportError does not say why: " + str(error))
        else:
            fail("import vtkshadow.headless worked")


def gl_by_symbol():
    """Before VTK 9.4 the headless window has to come first."""
    from vtkshadow._location import GL_BY_SYMBOL

    return GL_BY_SYMBOL


def of_vtk(module, *names):
    """Classes of the VTK that the package is for: there may be another one beside it."""
    from vtkshadow._build import VTK_PACKAGE

    loaded = importlib.import_module(f"{VTK_PACKAGE}.{module}")
    return [getattr(loaded, name) for name in names]


def vtk_first():
    from vtkshadow._build import VTK_PACKAGE

    importlib.import_module(VTK_PACKAGE)
    if gl_by_symbol():
        expect_import_error(["before", VTK_PACKAGE])
    else:
        import vtkshadow.headless


def hide(*libraries):
    """Goes on in a process whose loader finds empty files by these names first; the others' tests are not disturbed."""
    if os.environ.get("VTKSHADOW_TEST_HIDDEN"):
        return
    with tempfile.TemporaryDirectory() as folder:
        for library in libraries:
            for version in "", ".1", ".6", ".8":
                open(os.path.join(folder, f"lib{library}.so{version}"), "w").close()
        environment = dict(os.environ, LD_LIBRARY_PATH=folder, VTKSHADOW_TEST_HIDDEN="yes")
        sys.exit(subprocess.run([sys.executable, "-B", *sys.argv], env=environment).returncode)


def expect_import_error_without(library):
    hide(library)
    expect_import_error([library, "there is no"])


def nothing_chosen():
    """Either does; without both the error names both."""
    os.environ.pop("VTKSHADOW_HEADLESS", None)
    hide("OSMesa", "EGL")
    expect_import_error(["no OSMesa", "no EGL"])


def nothing_draws_beside_a_display():
    """From 9.4 on VTK's windows show themselves there."""
    os.environ.pop("VTKSHADOW_HEADLESS", None)
    os.environ["DISPLAY"] = ":987"
    hide("OSMesa", "EGL")
    if gl_by_symbol():
        expect_import_error(["no OSMesa", "no EGL"])
    else:
        import vtkshadow.headless


def nothing_chosen_no_osmesa():
    os.environ.pop("VTKSHADOW_HEADLESS", None)
    hide("OSMesa")
    if is_there("libEGL.so.1"):
        import vtkshadow.headless


def no_osmesa():
    os.environ["VTKSHADOW_HEADLESS"] = "osmesa"
    expect_import_error_without("OSMesa")


def no_egl():
    os.environ["VTKSHADOW_HEADLESS"] = "egl"
    expect_import_error_without("EGL")


def unknown_backend():
    os.environ["VTKSHADOW_HEADLESS"] = "display"
    expect_import_error(["display", "osmesa", "egl"])


def without_headless():
    """The pass alone needs neither OSMesa nor a display."""
    from vtkshadow import vtkShadowVolumePass

    if vtkShadowVolumePass().GetShadowIntensity() != 1.0:
        fail("a setting does not have its default")
    try:
        from vtkshadow import vtkHeadlessRenderWindow
    except ImportError as error:
        if "before" not in str(error):
            fail("the ImportError does not say why: " + str(error))
    else:
        if gl_by_symbol():
            fail("the headless window came although VTK was there first")
    try:
        from vtkshadow import noSuchClass
    except ImportError:
        return
    fail("a class was imported that is not there")


def add(renderer, source):
    vtkActor, vtkPolyDataMapper = of_vtk("vtkRenderingCore", "vtkActor", "vtkPolyDataMapper")

    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer.AddActor(actor)


def make_scene():
    vtkPlaneSource, vtkSphereSource = of_vtk("vtkFiltersSources", "vtkPlaneSource", "vtkSphereSource")
    vtkLight, vtkRenderer = of_vtk("vtkRenderingCore", "vtkLight", "vtkRenderer")

    renderer = vtkRenderer()
    ball = vtkSphereSource()
    ball.SetCenter(0, 0, 1)
    add(renderer, ball)
    table = vtkPlaneSource()
    table.SetOrigin(-2, -2, 0)
    table.SetPoint1(2, -2, 0)
    table.SetPoint2(-2, 2, 0)
    add(renderer, table)
    lamp = vtkLight()
    lamp.SetPositional(True)
    lamp.SetConeAngle(180)
    lamp.SetPosition(1, 1, 4)
    renderer.AddLight(lamp)
    renderer.GetActiveCamera().SetPosition(0, -6, 4)
    renderer.GetActiveCamera().SetViewUp(0, 0, 1)
    renderer.ResetCamera()
    return renderer


def is_there(name):
    try:
        ctypes.CDLL(name)
    except OSError as error:
        print(f"SKIPPED: there is no {name} to test: {error}")
        return False
    return True


def renders_by_osmesa():
    os.environ["VTKSHADOW_HEADLESS"] = "osmesa"
    if is_there("libOSMesa.so.8"):
        renders("OSMesa")


def renders_by_egl():
    os.environ["VTKSHADOW_HEADLESS"] = "egl"
    if is_there("libEGL.so.1"):
        renders("EGL")


def renders_by_what_there_is():
    os.environ.pop("VTKSHADOW_HEADLESS", None)
    has_osmesa, has_egl = (ctypes.util.find_library(name) is not None for name in ("OSMesa", "EGL"))
    renders("OSMesa" if has_osmesa and (gl_by_symbol() or not has_egl) else "EGL")


def renders(backend):
    import vtkshadow.headless
    (vtkUnsignedCharArray,) = of_vtk("vtkCommonCore", "vtkUnsignedCharArray")
    (vtkImageData,) = of_vtk("vtkCommonDataModel", "vtkImageData")
    from vtkshadow import vtkHeadlessRenderWindow, vtkShadowVolumePass

    renderer = make_scene()
    shadows = vtkShadowVolumePass()
    renderer.SetPass(shadows)
    window = vtkHeadlessRenderWindow()
    window.SetSize(160, 120)
    window.AddRenderer(renderer)
    window.Render()
    if not window.GetBackend().startswith(backend):
        fail("drawn by " + window.GetBackend())
    if shadows.GetStatus() != vtkShadowVolumePass.STATUS_OK:
        fail("status: " + shadows.GetStatusMessage())

    mask = vtkImageData()
    if not shadows.GetShadowMask(0, mask):
        fail("no shadow mask")
    values = mask.GetPointData().GetScalars()
    dark = sum(values.GetValue(i) == 0 for i in range(values.GetNumberOfValues()))
    if not 100 < dark < values.GetNumberOfValues() / 2:
        fail("%d pixels are in shadow" % dark)

    pixels = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, 159, 119, 0, pixels, 0)
    colours = {pixels.GetTuple3(i) for i in range(pixels.GetNumberOfTuples())}
    if len(colours) < 10:
        fail("the picture has only %d colours" % len(colours))
    expect_outlines(renderer, window, shadows)


def expect_outlines(renderer, window, shadows):
    (vtkImageData,) = of_vtk("vtkCommonDataModel", "vtkImageData")
    from vtkshadow import vtkSilhouettePass

    outlines = vtkSilhouettePass()
    outlines.SetDelegatePass(shadows)
    outlines.SetLineWidth(3.0)
    outlines.SetColor(1.0, 0.0, 0.0)
    renderer.SetPass(outlines)
    window.Render()
    if outlines.GetStatus() != vtkSilhouettePass.STATUS_OK or outlines.GetDelegatePass() is not shadows:
        fail("outlines: " + outlines.GetStatusMessage())
    mask = vtkImageData()
    if not outlines.GetLineMask(mask):
        fail("no line mask")
    values = mask.GetPointData().GetScalars()
    lines = sum(values.GetValue(i) == 255 for i in range(values.GetNumberOfValues()))
    if not 200 < lines < values.GetNumberOfValues() / 4:
        fail("%d pixels are lines" % lines)


CASES = (
    renders_by_osmesa,
    renders_by_egl,
    renders_by_what_there_is,
    vtk_first,
    no_osmesa,
    no_egl,
    nothing_chosen,
    nothing_chosen_no_osmesa,
    nothing_draws_beside_a_display,
    unknown_backend,
    without_headless,
)

if __name__ == "__main__":
    {case.__name__: case for case in CASES}[sys.argv[1]]()
