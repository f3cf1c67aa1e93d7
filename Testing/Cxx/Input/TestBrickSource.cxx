// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A volume whose samples are read when they are needed shows what it shows in memory, to the last
// byte: mapped, in bricks and from a reader, whatever changes from frame to frame. Its value ranges
// are found once.

#include "Checks/AreIdentical.h"
#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Walks/RandomViews.h"
#include "vtkTemporalCoherenceBrickSource.h"

#include <vtkByteSwap.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageReader2.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTestErrorObserver.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace
{

namespace fs = std::filesystem;
using Source = vtkTemporalCoherenceBrickSource;

constexpr int Nx = 100, Ny = 77, Nz = 68;

/// A folder that is gone in the end.
struct Folder
{
  Folder()
    : Path(fs::temp_directory_path() / ("bricks-" + std::to_string(std::rand())))
  {
    fs::create_directories(this->Path);
  }
  ~Folder()
  {
    std::error_code ignored;
    fs::remove_all(this->Path, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  fs::path Path;
};

/// Waves in an image of some type, about between -1700 and 1700, or 0 and 255.
vtkSmartPointer<vtkImageData> Waves(int type)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Nx, Ny, Nz);
  image->AllocateScalars(type, 1);
  vtkDataArray* const samples = image->GetPointData()->GetScalars();
  const bool isByte = type == VTK_UNSIGNED_CHAR;
  for (vtkIdType i = 0; i < samples->GetNumberOfTuples(); ++i)
  {
    const auto x = static_cast<double>(i % Nx), y = static_cast<double>(i / Nx % Ny),
               z = static_cast<double>(i / (Nx * Ny));
    const double wave =
      std::sin(0.2 * x) * std::cos(0.15 * y + 0.1 * z) + 0.5 * std::sin(0.3 * z + 0.05 * x);
    samples->SetComponent(
      i, 0, isByte ? std::floor(127.0 + 80.0 * wave) : std::floor(1100.0 * wave));
  }
  return image;
}

/// Write the samples of an image, as they are or with swapped bytes.
void Write(const fs::path& path, vtkImageData* image, bool isSwapped)
{
  vtkDataArray* const samples = image->GetPointData()->GetScalars();
  const auto size = static_cast<std::size_t>(samples->GetDataTypeSize());
  const auto count = static_cast<std::size_t>(samples->GetNumberOfTuples());
  std::vector<char> bytes(size * count);
  std::memcpy(bytes.data(), samples->GetVoidPointer(0), bytes.size());
  if (isSwapped)
  {
    vtkByteSwap::SwapVoidRange(bytes.data(), count, size);
  }
  std::ofstream(path, std::ios::binary)
    .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

#ifdef VTK_WORDS_BIGENDIAN
constexpr bool IsBigEndian = true;
#else
constexpr bool IsBigEndian = false;
#endif

/// How samples reach the mapper.
enum class Way
{
  Mapped,
  Swapped, ///< in bricks, as the byte order differs
  Reader
};

vtkSmartPointer<Source> Open(const fs::path& folder, vtkImageData* image, Way way)
{
  const fs::path path = folder / (way == Way::Swapped ? "swapped.raw" : "plain.raw");
  Write(path, image, way == Way::Swapped);
  auto source = vtkSmartPointer<Source>::New();
  source->SetMemoryLimit(1 << 20);
  source->SetRangesFolder(folder.string());
  if (way == Way::Reader)
  {
    vtkNew<vtkImageReader2> reader;
    reader->SetFileName(path.string().c_str());
    reader->SetFileDimensionality(3);
    reader->SetDataExtent(0, Nx - 1, 0, Ny - 1, 0, Nz - 1);
    reader->SetDataScalarType(image->GetScalarType());
    reader->SetDataByteOrder(
      IsBigEndian ? VTK_FILE_BYTE_ORDER_BIG_ENDIAN : VTK_FILE_BYTE_ORDER_LITTLE_ENDIAN);
    reader->FileLowerLeftOn();
    source->SetReader(reader);
    return source;
  }
  source->SetFileName(path.string());
  source->SetRawLayout(Nx, Ny, Nz, image->GetScalarType(), 0, IsBigEndian != (way == Way::Swapped));
  return source;
}

/// Two scenes that are changed alike.
struct Pair
{
  Pair(vtkImageData* image, Source* source, double isovalue)
    : Memory(image, { isovalue })
    , File(nullptr, { isovalue })
  {
    this->File.Mapper->SetBrickSource(source);
    this->File.Renderer->SetActiveCamera(this->Memory.Renderer->GetActiveCamera());
    this->Memory.LookFrom(1.0, 2.0, 0.5);
  }

  void Both(const std::function<void(Scene&)>& change)
  {
    change(this->Memory);
    change(this->File);
  }

  void ExpectSame(int width, int height, const std::string& what)
  {
    Expect(
      this->Memory.Render(width, height) && this->File.Render(width, height), what + ": drawn");
    Expect(AreIdentical(this->Memory.Color, this->File.Color) &&
        AreIdentical(this->Memory.Depth, this->File.Depth),
      what + ": not the picture of samples in memory");
    Expect(std::strcmp(this->Memory.Mapper->GetStatistics()->GetRouteAsString(),
             this->File.Mapper->GetStatistics()->GetRouteAsString()) == 0,
      what + ": another route");
    const int x = width / 2, y = height / 2;
    double here[3], there[3];
    const bool isHit = this->Memory.Mapper->PickPixel(x, y, here, nullptr, nullptr);
    Expect(isHit == this->File.Mapper->PickPixel(x, y, there, nullptr, nullptr) &&
        (!isHit || std::equal(here, here + 3, there)),
      what + ": another pick");
  }

  Scene Memory, File;
};

/// Change something at random, in both scenes.
void Change(Pair& pair, RandomViews& views, double middle, double width)
{
  vtkVolumeProperty* const property = pair.Memory.Volume->GetProperty();
  const double shift = views.Between(-width, width);
  switch (views.Pick(9))
  {
    case 0:
      pair.Both(
        [&](Scene& scene) {
          scene.SetIsovalues({ middle + shift, middle - 0.3 * shift });
        });
      break;
    case 1:
    case 2:
      pair.Both([&](Scene& scene) { scene.SetIsovalues({ middle + 0.3 * shift }); });
      break;
    case 3:
    {
      const double opacity = views.Pick(2) == 0 ? 1.0 : views.Between(0.2, 0.9);
      vtkNew<vtkPiecewiseFunction> opacities;
      opacities->AddPoint(middle, opacity);
      pair.Both([&](Scene& scene) { scene.Volume->GetProperty()->SetScalarOpacity(opacities); });
      break;
    }
    case 4:
    {
      const int mode = views.Pick(2);
      pair.Both([&](Scene& scene) { scene.Mapper->SetSurfaceMode(mode); });
      break;
    }
    case 5:
    {
      vtkNew<vtkPlane> plane;
      plane->SetOrigin(views.Between(20.0, 70.0), 30.0, 30.0);
      plane->SetNormal(1.0, 0.2, -0.1);
      const bool isClipped = views.Pick(2) == 0;
      pair.Both(
        [&](Scene& scene)
        {
          scene.Mapper->RemoveAllClippingPlanes();
          if (isClipped)
          {
            scene.Mapper->AddClippingPlane(plane);
          }
        });
      break;
    }
    case 6:
    {
      const bool isCropped = views.Pick(2) == 0;
      const double low = views.Between(5.0, 30.0);
      pair.Both(
        [&](Scene& scene)
        {
          scene.Mapper->SetCropping(isCropped);
          scene.Mapper->SetCroppingRegionPlanes(low, 80.0, low, 60.0, low, 55.0);
          scene.Mapper->SetCroppingRegionFlagsToSubVolume();
        });
      break;
    }
    case 7:
    {
      const bool isNearest = property->GetInterpolationType() != VTK_NEAREST_INTERPOLATION;
      pair.Both(
        [&](Scene& scene)
        {
          scene.Volume->GetProperty()->SetInterpolationType(
            isNearest ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
        });
      break;
    }
    default:
      views.Move();
      break;
  }
}

void TestWalks()
{
  const Folder folder;
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_FLOAT, VTK_DOUBLE })
  {
    const auto image = Waves(type);
    const double middle = type == VTK_UNSIGNED_CHAR ? 127.0 : 0.0;
    const double width = type == VTK_UNSIGNED_CHAR ? 60.0 : 900.0;
    for (const Way way : { Way::Mapped, Way::Swapped, Way::Reader })
    {
      if (way == Way::Swapped && type == VTK_UNSIGNED_CHAR)
      {
        continue; // a byte has no order
      }
      const auto source = Open(folder.Path, image, way);
      Pair pair(image, source, middle + 0.2 * width);
      RandomViews views(pair.Memory, static_cast<unsigned>(type), 70);
      for (int frame = 0; frame < 30; ++frame)
      {
        pair.ExpectSame(70 + views.Pick(3), 60,
          "type " + std::to_string(type) + ", way " + std::to_string(static_cast<int>(way)) +
            ", frame " + std::to_string(frame));
        Change(pair, views, middle, width);
      }
      Expect(source->GetIsMapped() == (way == Way::Mapped), "mapped where that is possible");
      Expect((source->GetNumberOfReads() > 0) == (way != Way::Mapped), "bricks were read");
    }
  }
}

/// Sizes at which blocks of 16 and 32 cells end.
void TestSizes()
{
  const Folder folder;
  for (const int n : { 2, 17, 31, 32, 33, 34, 65 })
  {
    const int sizes[3][3] = { { n, 40, 37 }, { 40, n, 37 }, { 37, 40, n } };
    for (const auto& size : sizes)
    {
      const auto image = vtkSmartPointer<vtkImageData>::New();
      image->SetDimensions(size);
      image->AllocateScalars(VTK_SHORT, 1);
      auto* const samples = static_cast<short*>(image->GetScalarPointer());
      for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
      {
        samples[i] = static_cast<short>(800 + i * 7919 % 700); // no sample is 0
      }
      for (const Way way : { Way::Mapped, Way::Swapped })
      {
        const fs::path path = folder.Path / (way == Way::Mapped ? "sizes.raw" : "swapped.raw");
        Write(path, image, way == Way::Swapped);
        vtkNew<Source> source;
        source->SetFileName(path.string());
        source->SetRawLayout(size, VTK_SHORT, 0, IsBigEndian != (way == Way::Swapped));
        source->SetMemoryLimit(1 << 20);
        Pair pair(image, source, 1100.0);
        const std::string what = std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
          std::to_string(size[2]);
        pair.ExpectSame(60, 50, what);
        double range[2], expected[2];
        source->GetOutput()->GetScalarRange(range);
        image->GetScalarRange(expected);
        Expect(range[0] == expected[0] && range[1] == expected[1], what + ": the range of values");
      }
    }
  }
}

/// Ambient occlusion, shadows, projections and composite volumes.
void TestOtherPictures()
{
  const Folder folder;
  const auto image = Waves(VTK_SHORT);
  const auto source = Open(folder.Path, image, Way::Swapped);
  Pair pair(image, source, 200.0);
  pair.Both([](Scene& scene) { scene.Mapper->AmbientOcclusionOn(); });
  pair.ExpectSame(60, 50, "ambient occlusion");
  pair.Both([](Scene& scene) { scene.Mapper->AmbientOcclusionOff(); });
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(-1000.0, 0.0);
  opacities->AddPoint(1500.0, 0.6);
  pair.Both([&](Scene& scene) { scene.Volume->GetProperty()->SetScalarOpacity(opacities); });
  for (const int mode : { vtkVolumeMapper::COMPOSITE_BLEND,
         vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, vtkVolumeMapper::MINIMUM_INTENSITY_BLEND,
         vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, vtkVolumeMapper::ADDITIVE_BLEND })
  {
    pair.Both([&](Scene& scene) { scene.Mapper->SetBlendMode(mode); });
    pair.ExpectSame(60, 50, "blend mode " + std::to_string(mode));
  }
}

/// Filters of VTK see an ordinary image.
void TestOtherFilters()
{
  const Folder folder;
  const auto image = Waves(VTK_SHORT);
  const auto source = Open(folder.Path, image, Way::Swapped);
  source->Update();
  vtkDataArray* const samples = source->GetOutput()->GetPointData()->GetScalars();
  double range[2], expected[2];
  samples->GetRange(range);
  image->GetScalarRange(expected);
  Expect(range[0] == expected[0] && range[1] == expected[1], "the range of values");
  bool areSame = samples->GetNumberOfTuples() == image->GetNumberOfPoints();
  for (vtkIdType i = 0; areSame && i < image->GetNumberOfPoints(); i += 97)
  {
    areSame =
      samples->GetComponent(i, 0) == image->GetPointData()->GetScalars()->GetComponent(i, 0);
  }
  Expect(areSame, "values one by one");
  vtkNew<vtkImageData> copy;
  copy->DeepCopy(source->GetOutput());
  Expect(AreIdentical(copy, image), "a copy has samples of its own");
  // Other values in a copy are drawn, not those of the file.
  static_cast<short*>(copy->GetScalarPointer())[5] = 30000;
  copy->Modified();
  Pair pair(image, source, 200.0);
  auto* const changed = static_cast<short*>(image->GetScalarPointer());
  changed[5] = 30000;
  image->Modified();
  pair.File.Mapper->SetInputData(copy);
  pair.ExpectSame(60, 50, "a copy with another value");
  vtkNew<vtkFlyingEdges3D> inCopy, inBricks;
  inCopy->SetInputData(copy);
  inCopy->SetValue(0, 200.0);
  inCopy->Update();
  inBricks->SetInputConnection(source->GetOutputPort());
  inBricks->SetValue(0, 200.0);
  inBricks->Update();
  Expect(std::abs(inCopy->GetOutput()->GetNumberOfPoints() -
           inBricks->GetOutput()->GetNumberOfPoints()) < 10 &&
      inBricks->GetOutput()->GetNumberOfPoints() > 1000,
    "a filter that asks for the address of samples");
}

void TestRangesFile()
{
  const Folder folder;
  const auto image = Waves(VTK_SHORT);
  const auto open = [&]()
  {
    const auto source = Open(folder.Path, image, Way::Swapped);
    source->Update();
    return source;
  };
  Expect(!open()->GetHadRanges(), "the first opening finds the ranges");
  // Open() writes the volume anew, which is another state of it.
  const fs::path volume = folder.Path / "swapped.raw";
  const auto again = vtkSmartPointer<Source>::New();
  const auto set = [&](Source* source)
  {
    source->SetFileName(volume.string());
    source->SetRawLayout(Nx, Ny, Nz, VTK_SHORT, 0, !IsBigEndian);
    source->SetRangesFolder(folder.Path.string());
  };
  set(again);
  again->Update();
  Expect(again->GetHadRanges(), "the second opening has the ranges");

  // Damaged files are made anew.
  fs::path ranges;
  for (const auto& entry : fs::directory_iterator(folder.Path))
  {
    ranges = entry.path().extension() == ".ranges" ? entry.path() : ranges;
  }
  Expect(!ranges.empty(), "there is a file of ranges");
  const auto size = fs::file_size(ranges);
  again->Close();
  for (const auto length : { std::uintmax_t(0), std::uintmax_t(100), size - 1 })
  {
    fs::resize_file(ranges, length);
    again->Close();
    again->Update();
    Expect(!again->GetHadRanges() && fs::file_size(ranges) == size, "a short file is made anew");
  }
  {
    std::fstream file(ranges, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(60);
    file.put('7');
  }
  again->Close();
  again->Update();
  Expect(!again->GetHadRanges(), "a file with another head is made anew");
  Scene scene(nullptr, { 200.0 });
  scene.Mapper->SetBrickSource(again);
  Scene memory(image, { 200.0 });
  memory.LookFrom(1.0, 2.0, 0.5);
  scene.Renderer->SetActiveCamera(memory.Renderer->GetActiveCamera());
  Expect(scene.Render(50, 50) && memory.Render(50, 50) && AreIdentical(scene.Color, memory.Color),
    "the picture after damage");
}

/// What cannot be read is said, and counts as zeros.
void TestMistakes()
{
  const Folder folder;
  vtkNew<vtkTest::ErrorObserver> errors;
  const auto source = vtkSmartPointer<Source>::New();
  source->AddObserver(vtkCommand::ErrorEvent, errors);
  source->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  const auto expectError = [&](const std::string& word)
  {
    source->Update();
    Expect(errors->GetError() && errors->GetErrorMessage().find(word) != std::string::npos,
      "an error that names " + word + ", not " + errors->GetErrorMessage());
    errors->Clear();
  };
  expectError("SetFileName");
  source->SetFileName((folder.Path / "nothing.raw").string());
  expectError("not there");
  std::ofstream(folder.Path / "some.raw") << "abc";
  source->SetFileName((folder.Path / "some.raw").string());
  expectError("SetRawLayout");
  source->SetRawLayout(10, 10, 10, VTK_SHORT);
  expectError("some.raw");
  source->SetRawLayout(2147483647, 2147483647, 2147483647, VTK_DOUBLE);
  expectError("some.raw");
  source->SetRawLayout(10, 10, 10, VTK_STRING);
  expectError("SetRawLayout");

  source->SetRawLayout(1, 1, 1, VTK_UNSIGNED_CHAR);
  expectError("two or more");

  // The file becomes shorter after it was opened.
  const auto image = Waves(VTK_SHORT);
  for (const Way way : { Way::Swapped, Way::Mapped })
  {
    const auto read = Open(folder.Path, image, way);
    read->Update();
    fs::resize_file(read->GetFileName(), 4096 * 20);
    Scene scene(nullptr, { 200.0 });
    vtkNew<vtkTest::ErrorObserver> ofMapper;
    scene.Mapper->AddObserver(vtkCommand::ErrorEvent, ofMapper);
    scene.Mapper->SetBrickSource(read);
    scene.LookFrom(1.0, 2.0, 0.5);
    scene.Render(60, 50);
    Expect(ofMapper->GetError() && ofMapper->GetErrorMessage().find(".raw") != std::string::npos,
      "a file that became shorter is said: " + ofMapper->GetErrorMessage());
  }
}

}

int TestBrickSource(int, char*[])
{
  TestWalks();
  TestSizes();
  TestOtherPictures();
  TestOtherFilters();
  TestRangesFile();
  TestMistakes();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
