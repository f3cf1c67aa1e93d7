// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HeaderFiles_h
#define TemporalCoherence_HeaderFiles_h

#include "RawFiles.h"
#include "VolumeFiles/VtkTypes.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMetaImageWriter.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataWriter.h>

/// \file
/// Images in files with headers, for tests.

namespace TemporalCoherence
{

/// An image of 5 x 4 x 3 samples SampleAt(), whose first index is not 0. Sample (0, 0, 0) of the
/// file lies at (11, 19.5, 30.75).
inline vtkNew<vtkImageData> MakeImage(ScalarType type)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(2, 6, -1, 2, 3, 5);
  image->SetSpacing(0.5, 0.5, 0.25);
  image->SetOrigin(10.0, 20.0, 30.0);
  image->AllocateScalars(VtkTypeOf(type), 1);
  image->GetPointData()->GetScalars()->SetName("density");
  DispatchScalarType(type,
    [&](auto zero)
    {
      using T = decltype(zero);
      const std::string bytes = SampleBytes<T>(5 * 4 * 3, false);
      std::memcpy(image->GetScalarPointer(), bytes.data(), bytes.size());
    });
  return image;
}

/// Write an image by VTK: appended, raw, not compressed.
/// \param change settings of the writer
template <typename Change>
void WriteVti(const std::string& path, vtkImageData* image, const Change& change)
{
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  change(writer.Get());
  ASSERT_EQ(writer->Write(), 1);
}

inline void WriteMetaImage(const std::string& path, vtkImageData* image)
{
  vtkNew<vtkMetaImageWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->SetCompression(false);
  writer->Write();
}

/// The text with a part replaced; the part must be there.
inline std::string Replaced(std::string text, const std::string& part, const std::string& by)
{
  const std::size_t place = text.find(part);
  EXPECT_NE(place, std::string::npos) << part;
  return place == std::string::npos ? text : text.replace(place, part.size(), by);
}

inline void ExpectPlaces(
  const VolumeFile& file, const glm::ivec3& size, const glm::dvec3& origin, const glm::dvec3& step)
{
  EXPECT_EQ(file.Levels().front().Dimensions, size);
  EXPECT_EQ(file.Levels().front().Origin, origin);
  EXPECT_EQ(file.Levels().front().Spacing, step);
}

}

#endif
