"""Where the passes stand among those that PyVista, or its user, has set."""

import math

# VTK under the name that PyVista knows it by, which is not the same everywhere.
from pyvista.plotting.render_passes import _vtk

from vtkshadow import vtkShadowVolumePass

_ours, _theirs = vtkShadowVolumePass.__mro__[-2], _vtk.vtkCameraPass.__mro__[-2]  # vtkObjectBase
if _ours is not _theirs:
    raise ImportError(f"vtkshadow was built for {_ours.__module__}, but PyVista uses {_theirs.__module__}: "
                      "PYVISTA_VTK_BACKEND chooses what it uses")


def _is_shadow_map(item):
    return item.IsA("vtkShadowMapPass") or item.IsA("vtkShadowMapBakerPass")


def _items(drawing):
    """What a camera pass has below it, one after the other."""
    if drawing is None or not drawing.IsA("vtkSequencePass"):
        return [] if drawing is None else [drawing]
    passes = drawing.GetPasses()
    return [] if passes is None else [passes.GetItemAsObject(i) for i in range(passes.GetNumberOfItems())]


def _steps_with(effects, steps):
    """Steps like those given, but for the opaque one."""
    ours = _vtk.vtkRenderStepsPass()
    ours.SetOpaquePass(effects.opaque(steps.GetOpaquePass()))
    if steps.GetCameraPass() is None:
        ours.SetCameraPass(None)  # else its own: it knows the steps that it belongs to
    for step in ("Lights", "Translucent", "Volumetric", "Overlay", "PostProcess"):
        getattr(ours, f"Set{step}Pass")(getattr(steps, f"Get{step}Pass")())
    return ours


def sequence_with(effects, drawing):
    """A new sequence that draws like the pass given, with our passes where that draws what is opaque.

    Exact shadows take the place of shadow maps; lines alone go over them. None where it draws nothing opaque that is
    known.
    """
    items = _items(drawing)
    if effects.settings["enabled"]:
        items = [item for item in items if not _is_shadow_map(item)]
    maps = [item for item in items if item.IsA("vtkShadowMapPass")]
    collection, found = _vtk.vtkRenderPassCollection(), False
    for item in items:
        if item in maps or item.IsA("vtkOpaquePass"):
            item, found = effects.opaque(item), True
        elif item.IsA("vtkRenderStepsPass") and not maps:
            item, found = _steps_with(effects, item), True
        collection.AddItem(item)
    if not found:
        return None
    sequence = _vtk.vtkSequencePass()
    sequence.SetPasses(collection)
    return sequence


def camera_with(effects, camera):
    """A new camera pass like the one given, around sequence_with(); None where there can be none."""
    if not camera.IsA("vtkCameraPass"):
        return None
    sequence = sequence_with(effects, camera.GetDelegatePass())
    if sequence is None:
        return None
    ours = _vtk.vtkCameraPass()
    ours.SetAspectRatioOverride(camera.GetAspectRatioOverride())
    ours.SetDelegatePass(sequence)
    return ours


def _down_to_camera(top):
    """A chain of delegates, down to the first camera pass."""
    found = []
    while top is not None and top not in found:
        found.append(top)
        if top.IsA("vtkCameraPass"):
            break
        top = top.GetDelegatePass() if hasattr(top, "GetDelegatePass") else None
    return found


def _camera_below(top):
    cameras = [each for each in _down_to_camera(top) if each.IsA("vtkCameraPass")]
    return cameras[0] if cameras else None


def supersampling(top):
    """How many pixels the lowest pass draws, each way, for one of the window."""
    factor = 1.0
    for each in _down_to_camera(top):
        if each.IsA("vtkSSAAPass"):
            factor *= math.sqrt(5)  # VTK's, which is fixed
        elif each.IsA("pvSSAAVolumePass"):
            factor *= each.GetSupersampleFactor()
    return factor


class Chain:
    """Puts the passes into the renderer's own, and takes them out again.

    PyVista keeps one camera pass, below all others, and only ever asks for that. So nothing of PyVista's is
    changed but what this camera pass draws, and nothing of ours is lost when it strings the others together anew.
    """

    def __init__(self, renderer):
        self._renderer = renderer
        self._top = None  # ours, while there is no other
        self._camera = None  # whose delegate is our sequence
        self._plain = None  # the delegate it had
        self._sequence = None
        self._made_from = None
        self.remarks = []

    def compose(self, effects):
        """To be called before every picture: others may have changed the renderer's pass."""
        self.remarks = []
        top = self._renderer.GetPass()
        if not effects.active:
            self.restore()
        elif top is None or top is self._top:
            self._stand_alone(top, effects)
        else:
            self._top = None
            self._enter(top, effects)
        effects.scale_lines(supersampling(self._renderer.GetPass()))

    def _stand_alone(self, top, effects):
        ours = effects.complete()
        if top is not ours:
            self.restore()
            self._top = ours
            self._renderer.SetPass(ours)

    def restore(self):
        """Leaves the renderer as it is without us."""
        if self._top is not None and self._renderer.GetPass() is self._top:
            self._renderer.SetPass(None)
        if self._camera is not None and self._camera.GetDelegatePass() is self._sequence:
            self._camera.SetDelegatePass(self._plain)
        self._top = self._camera = self._plain = self._sequence = self._made_from = None

    def _enter(self, top, effects):
        camera = _camera_below(top)
        if self._camera is not None and (camera is not self._camera or
                                         camera.GetDelegatePass() is not self._sequence):
            self.restore()
        if self._camera is None and camera is not None:
            self._plain = camera.GetDelegatePass()
        made_from = [*_items(self._plain), effects.settings["enabled"], effects.settings["outlines"] is not None]
        if self._sequence is None or made_from != self._made_from:
            sequence = sequence_with(effects, self._plain)
            if sequence is None:
                self.restore()
            else:
                self._camera, self._sequence, self._made_from = camera, sequence, made_from
                camera.SetDelegatePass(sequence)
        if self._sequence is None:
            self.remarks.append(f"not drawn: it is not known what below {top.GetClassName()} draws what is opaque")
        elif effects.settings["enabled"] and any(map(_is_shadow_map, _items(self._plain))):
            self.remarks.append("shadow maps are left out while there are exact shadows")
