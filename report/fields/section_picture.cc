#include "report/fields/section_picture.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "core/error.h"

namespace asperity::report {
namespace {

constexpr unsigned longest_drawing_seconds = 120;

Image empty_image(const SectionView& view) {
  return {view.width, std::max(1, static_cast<int>(view.width * (view.z_high - view.z_low) /
                                                   (view.x_high - view.x_low)))};
}

Image draw(vtkPolyData& section, const SectionView& view) {
  Image image = empty_image(view);
  vtkNew<vtkLookupTable> colours;
  colours->SetNumberOfTableValues(256);
  for (int i = 0; i < 256; ++i) {
    const Colour colour = view.scale->at(i / 255.0);
    colours->SetTableValue(i, colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
  }
  colours->SetRange(view.range.low, view.range.high);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(&section);
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray(view.array.c_str());
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  // Single precision on the graphics side wants coordinates of order one.
  const double unit = (view.z_high - view.z_low) / 2;
  vtkNew<vtkTransform> scaling;
  scaling->Scale(1 / unit, 1 / unit, 1 / unit);
  actor->SetUserTransform(scaling);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetEdgeVisibility(view.edges);
  actor->GetProperty()->SetEdgeColor(0.45, 0.45, 0.45);
  actor->GetProperty()->SetLineWidth(0.5F);

  vtkNew<vtkRenderer> renderer;
  const Colour outside = view.scale->at(std::numeric_limits<double>::quiet_NaN());
  renderer->SetBackground(outside[0] / 255.0, outside[1] / 255.0, outside[2] / 255.0);
  renderer->AddActor(actor);
  vtkCamera* camera = renderer->GetActiveCamera();
  const double x = (view.x_low + view.x_high) / 2 / unit, z = (view.z_low + view.z_high) / 2 / unit;
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(x, 0, z);
  camera->SetPosition(x, -10, z);
  camera->SetViewUp(0, 0, 1);
  camera->SetParallelScale(1);
  camera->SetClippingRange(1, 20);

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetSize(image.width, image.height);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkWindowToImageFilter> capture;
  capture->SetInput(window);
  capture->SetInputBufferTypeToRGB();
  capture->ReadFrontBufferOff();
  capture->Update();
  vtkImageData* pixels = capture->GetOutput();
  for (int y = 0; y < image.height; ++y)
    std::copy_n(static_cast<const std::uint8_t*>(pixels->GetScalarPointer(0, image.height - 1 - y, 0)),
                3 * image.width, image.pixel(0, y));
  return image;
}

bool write_all(int file, const std::vector<std::uint8_t>& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = write(file, bytes.data() + done, bytes.size() - done);
    if (count <= 0) return false;
    done += static_cast<std::size_t>(count);
  }
  return true;
}

bool read_all(int file, std::vector<std::uint8_t>& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = read(file, bytes.data() + done, bytes.size() - done);
    if (count <= 0) return false;
    done += static_cast<std::size_t>(count);
  }
  return true;
}

[[noreturn]] void draw_in_child(vtkPolyData& section, const std::vector<SectionView>& views,
                                const std::string& display, int output) {
  setenv("DISPLAY", display.c_str(), 1);
  alarm(longest_drawing_seconds);
  const int silence = open("/dev/null", O_WRONLY);
  dup2(silence, STDERR_FILENO);
  for (const auto& view : views)
    if (!write_all(output, draw(section, view).rgb)) break;
  _exit(0);
}

}  // namespace

std::vector<Image> draw_sections(vtkPolyData& section, const std::vector<SectionView>& views,
                                 const std::string& display) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw WorkError("no pipe to the drawing process could be opened");
  const pid_t child = fork();
  if (child == 0) draw_in_child(section, views, display, ends[1]);
  close(ends[1]);
  std::vector<Image> images;
  bool complete = child > 0;
  for (const auto& view : views) {
    images.push_back(empty_image(view));
    complete = complete && read_all(ends[0], images.back().rgb);
  }
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  if (!complete)
    throw WorkError("VTK could not draw on display " + display +
                    "; is software OpenGL (package libgl1-mesa-dri) installed?");
  return images;
}

}  // namespace asperity::report
