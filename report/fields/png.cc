#include "report/fields/png.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include "core/base64.h"

namespace asperity::report {

std::string png_bytes(const Image& image) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < image.height; ++y)  // VTK counts rows from below
    std::copy_n(image.pixel(0, y), 3 * image.width,
                static_cast<std::uint8_t*>(data->GetScalarPointer(0, image.height - 1 - y, 0)));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(data);
  writer->WriteToMemoryOn();
  writer->Write();
  const vtkUnsignedCharArray* bytes = writer->GetResult();
  auto* begin = const_cast<vtkUnsignedCharArray*>(bytes)->GetPointer(0);
  return {reinterpret_cast<const char*>(begin), static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

std::string data_uri(const Image& image) { return "data:image/png;base64," + base64(png_bytes(image)); }

}  // namespace asperity::report
