#include "fem/output/paraview_script.h"

namespace asperity::fem {
namespace {

constexpr const char* script =
    R"python(# What `asperity solve` wrote beside this file, as a picture in ParaView (checked with 5.11):
#   paraview --script=show_in_paraview.py      or File > Load State... in a ParaView that runs
#   pvbatch show_in_paraview.py picture.png    without a screen
# Left: von Mises stress in both bodies, displaced and cut at the largest pressure; white: a tenth of the
# largest plastic strain. Right: the contact pressure, seen from above.
import os
import sys

from paraview.simple import *

FOLDER = os.path.dirname(os.path.abspath(__file__)) if '__file__' in globals() else os.getcwd()


def time_of_largest_load(reader):
    """The frame that is shown first."""
    times = reader.TimestepValues
    times = list(times) if hasattr(times, '__iter__') else [times]
    loads = []
    for time in times:
        reader.UpdatePipeline(time)
        loads.append(servermanager.Fetch(reader).GetFieldData().GetArray('load [N]').GetValue(0))
    return times[loads.index(max(loads))]


def colour(shown, view, place, name, title):
    ColorBy(shown, (place, name))
    shown.RescaleTransferFunctionToDataRange(False, True)
    bar = GetScalarBar(GetColorTransferFunction(name), view)
    bar.Title, bar.ComponentTitle = title, ''
    shown.SetScalarBarVisibility(view, True)


def look(view, centre, direction, up, half_height):
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = centre
    view.CameraPosition = [c + 10 * half_height * d for c, d in zip(centre, direction)]
    view.CameraViewUp = up
    view.CameraParallelScale = half_height


bodies = PVDReader(registrationName='bodies', FileName=os.path.join(FOLDER, 'fields.pvd'))
contact = PVDReader(registrationName='contact', FileName=os.path.join(FOLDER, 'interface.pvd'))
time = time_of_largest_load(contact)
bodies.UpdatePipeline(time)
contact.UpdatePipeline(time)
surface = servermanager.Fetch(contact)
pressure = surface.GetPointData().GetArray('pressure')
presses = [n for n in range(surface.GetNumberOfPoints()) if pressure.GetValue(n) > 0]
places = [surface.GetPoint(n) for n in presses or range(surface.GetNumberOfPoints())]
low, high = [min(axis) for axis in zip(*places)], [max(axis) for axis in zip(*places)]
centre = [0.5 * (l + h) for l, h in zip(low, high)]
width = max(h - l for l, h in zip(low, high))
peak = surface.GetPoint(max(presses, key=pressure.GetValue)) if presses else centre

layout = CreateLayout('contact')
left = CreateView('RenderView')
AssignViewToLayout(view=left, layout=layout, hint=0)
layout.SplitHorizontal(0, 0.5)
right = CreateView('RenderView')
AssignViewToLayout(view=right, layout=layout, hint=2)

warped = WarpByVector(registrationName='displaced', Input=bodies)
warped.Vectors, warped.ScaleFactor = ['POINTS', 'motion'], 1.0
section = Clip(registrationName='section', Input=warped, ClipType='Plane')
section.ClipType.Origin, section.ClipType.Normal, section.Invert = list(peak), [0.0, 1.0, 0.0], 0
section.UpdatePipeline(time)
shown = Show(section, left)
colour(shown, left, 'CELLS', 'von_mises', 'von Mises stress [Pa]')
strain = section.PointData.GetArray('plastic_strain_at_nodes').GetRange()[1]
if strain > 0:
    yielded = Contour(registrationName='yielded', Input=section)
    yielded.ContourBy, yielded.Isosurfaces = ['POINTS', 'plastic_strain_at_nodes'], [0.1 * strain]
    outline = Show(yielded, left)
    ColorBy(outline, None)
    outline.DiffuseColor = [1.0, 1.0, 1.0]

shown = Show(contact, right)
colour(shown, right, 'POINTS', 'pressure', 'contact pressure [Pa]')
for name, place in (('title', 'Upper Left Corner'), ('load [N]', 'Lower Left Corner')):
    note = AnnotateAttributeData(registrationName=name, Input=contact)
    note.SelectInputArray = ['FIELD', name]
    note.Prefix = '' if name == 'title' else name + ': '
    Show(note, right, 'TextSourceRepresentation').WindowLocation = place

scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.AnimationTime = time
left.ViewTime = right.ViewTime = time
RenderAllViews()
look(left, [centre[0], peak[1], centre[2]], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], width)
look(right, centre, [0.0, 0.0, 1.0], [0.0, 1.0, 0.0], 0.75 * width)
RenderAllViews()
if len(sys.argv) > 1 and sys.argv[-1].endswith('.png'):
    layout.SetSize(1600, 800)
    SaveScreenshot(sys.argv[-1], layout, ImageResolution=[1600, 800])
)python";

}  // namespace

std::string paraview_script() { return script; }

}  // namespace asperity::fem
