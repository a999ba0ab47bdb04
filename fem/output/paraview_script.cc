#include "fem/output/paraview_script.h"

#include "core/printed.h"

namespace asperity::fem {
namespace {

constexpr const char* script =
    R"python(# What `asperity solve` wrote beside this file, as a picture in ParaView:
#   pvbatch show_in_paraview.py picture.png    draws it (checked with 5.11)
#   paraview --script=show_in_paraview.py      or File > Load State... in a ParaView that runs (not tried)
# Left: von Mises stress in both bodies, displaced and cut at the largest pressure; white: a tenth of the
# largest plastic strain. Right: the contact pressure, seen from above, upright beside the section.
import os
import sys

from paraview.simple import *

WRITTEN_TO = os.fsdecode(bytes.fromhex('@folder@'))  # the folder's name in bytes


def folder_of_the_case():
    """Beside this file, which ParaView with a screen does not tell the place of, or where it was written."""
    own = [os.path.dirname(os.path.abspath(__file__))] if '__file__' in globals() else []
    for place in own + [WRITTEN_TO, os.getcwd()]:
        if os.path.exists(os.path.join(place, 'fields.pvd')):
            return place
    raise FileNotFoundError(f'no fields.pvd in {WRITTEN_TO}; start ParaView in the folder of this script')


FOLDER = folder_of_the_case()


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

view = GetActiveViewOrCreate('RenderView')

warped = WarpByVector(registrationName='displaced', Input=bodies)
warped.Vectors, warped.ScaleFactor = ['POINTS', 'motion'], 1.0
section = Clip(registrationName='section', Input=warped, ClipType='Plane')
section.ClipType.Origin, section.ClipType.Normal, section.Invert = list(peak), [0.0, 1.0, 0.0], 0
section.UpdatePipeline(time)
shown = Show(section, view)
colour(shown, view, 'CELLS', 'von_mises', 'von Mises stress [Pa]')
strain = section.PointData.GetArray('plastic_strain_at_nodes').GetRange()[1]
if strain > 0:
    yielded = Contour(registrationName='yielded', Input=section)
    yielded.ContourBy, yielded.Isosurfaces = ['POINTS', 'plastic_strain_at_nodes'], [0.1 * strain]
    outline = Show(yielded, view)
    ColorBy(outline, None)
    outline.DiffuseColor = [1.0, 1.0, 1.0]

# The map of the pressure stands upright beside the section, y upwards.
upright = Transform(registrationName='pressure', Input=contact)
upright.Transform.Rotate = [90.0, 0.0, 0.0]
upright.Transform.Translate = [2.2 * width, peak[1] + centre[2] - 0.5 * width, centre[2] - centre[1]]
shown = Show(upright, view)
colour(shown, view, 'POINTS', 'pressure', 'contact pressure [Pa]')
for name, place in (('title', 'Upper Left Corner'), ('load [N]', 'Lower Left Corner')):
    note = AnnotateAttributeData(registrationName=name, Input=contact)
    note.SelectInputArray = ['FIELD', name]
    note.Prefix = '' if name == 'title' else name + ': '
    Show(note, view, 'TextSourceRepresentation').WindowLocation = place

scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.AnimationTime = time
view.ViewTime = time
Render(view)
look(view, [centre[0] + 1.1 * width, peak[1], centre[2]], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], 1.25 * width)
Render(view)
if len(sys.argv) > 1 and sys.argv[-1].endswith('.png'):
    view.ViewSize = [1600, 800]
    SaveScreenshot(sys.argv[-1], view, ImageResolution=[1600, 800])
)python";

}  // namespace

std::string paraview_script(const std::filesystem::path& folder) {
  const std::string place = std::filesystem::absolute(folder).lexically_normal().string(), mark = "@folder@";
  std::string bytes, text = script;
  for (const unsigned char byte : place) bytes += printed("%02x", byte);
  return text.replace(text.find(mark), mark.size(), bytes);
}

}  // namespace asperity::fem
