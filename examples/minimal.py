"""The least it takes to give an ordinary VTK scene exact shadows. Writes minimal.png, without a display."""

import vtkshadow.headless  # before anything of VTK; leave it out where there is a display

from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkWindowToImageFilter
import vtkmodules.vtkRenderingOpenGL2

from vtkshadow import vtkHeadlessRenderWindow, vtkShadowVolumePass


def add(renderer, source, y):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(0, y, 0)
    renderer.AddActor(actor)


renderer = vtkRenderer()
add(renderer, vtkSphereSource(), 1.0)
table = vtkCubeSource()
table.SetXLength(4)
table.SetZLength(4)
add(renderer, table, -0.5)

lamp = vtkLight()
lamp.SetPositional(True)
lamp.SetConeAngle(180)
lamp.SetPosition(-3, 5, 2)
renderer.AddLight(lamp)

shadows = vtkShadowVolumePass()
renderer.SetPass(shadows)  # this line gives the scene its shadows

window = vtkHeadlessRenderWindow()
window.SetSize(640, 480)
window.AddRenderer(renderer)
renderer.GetActiveCamera().SetPosition(2, 3, 6)
renderer.ResetCamera()
window.Render()

picture = vtkWindowToImageFilter()
picture.SetInput(window)
picture.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetInputConnection(picture.GetOutputPort())
writer.SetFileName("minimal.png")
writer.Write()
