// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// usage: DropIn [VOLUME.vti ISOVALUE]   An isosurface, drawn without a window into dropin.png
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRTAnalyticSource.h>
#include <vtkRenderer.h>
#include <vtkTemporalCoherenceVolumeMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <vtkXMLImageDataReader.h>

#include <cstdlib>

int main(int argc, char* argv[])
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-60, 60, -60, 60, -60, 60);
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(argc == 3 ? argv[1] : nullptr);
  const double isovalue = argc == 3 ? std::atof(argv[2]) : 150.0;

  // The drop-in: here stood vtkGPUVolumeRayCastMapper and SetBlendModeToIsoSurface.
  vtkNew<vtkTemporalCoherenceVolumeMapper> mapper;
  mapper->SetInputConnection(argc == 3 ? reader->GetOutputPort() : wavelet->GetOutputPort());
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->GetIsoSurfaceValues()->SetValue(0, isovalue);
  volume->GetProperty()->GetRGBTransferFunction()->AddRGBPoint(isovalue, 0.95, 0.75, 0.45);
  volume->GetProperty()->SetInterpolationTypeToLinear();
  volume->GetProperty()->ShadeOn();
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->ResetCamera();

  // With a render window, vtkRenderWindow::Render() draws it as any volume; without one:
  vtkNew<vtkImageData> picture;
  const bool isDrawn = mapper->MakeImage(renderer, volume, 512, 512, picture, nullptr);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->SetFileName("dropin.png");
  writer->Write();
  return isDrawn && writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
