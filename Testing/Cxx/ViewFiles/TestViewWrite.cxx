// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Views are written with their names and texts, as a page and as a file alike. A stop at any
// report, and any mistake, leaves no new file and the old one as it was. Mistakes become one
// sentence.

#include "ViewScene.h"
#include "Volumes/Volumes.h"

#include <vtkFloatingPointExceptions.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <sstream>

namespace
{

/// Asks a writer to stop at one of its reports, and writes these down.
class StopAt
{
public:
  StopAt(vtkTemporalCoherenceViewWriter* writer, int report)
    : Of(writer)
    , Left(report)
    , Tag(writer->AddObserver(vtkCommand::ProgressEvent, this, &StopAt::Hear))
  {
  }
  ~StopAt() { this->Of->RemoveObserver(this->Tag); }
  StopAt(const StopAt&) = delete;
  StopAt& operator=(const StopAt&) = delete;

  double Done = 0.0;
  bool IsRising = true;

private:
  void Hear(vtkObject*, unsigned long, void* data)
  {
    const double now = *static_cast<double*>(data);
    this->IsRising = this->IsRising && now >= this->Done && now <= 1.0;
    this->Done = now;
    if (this->Left-- == 0)
    {
      this->Of->AbortExecuteOn();
    }
  }

  vtkTemporalCoherenceViewWriter* Of;
  int Left;
  unsigned long Tag;
};

void TestTexts(const ScratchFolder& folder)
{
  ViewScene scene(Volumes::FourSpheres(24));
  const std::string title = "\"Gr\xc3\xbc\xc3\x9f"
                            "e\" & 'more'",
                    caption = "</script><script>x()</script>", citation = "<!-- <b>@TITLE@</b>",
                    units = "g/cm\xc2\xb3";
  scene.Writer->SetTitle(title.c_str());
  scene.Writer->SetCaption(caption.c_str());
  scene.Writer->SetCitation(citation.c_str());
  scene.Writer->SetUnits(units.c_str());
  scene.Writer->AddOrbit(3, scene.Renderer);
  scene.Writer->AddView("</script> \xc3\xa4", scene.Renderer->GetActiveCamera());
  std::string headers[2];
  int kind = 0;
  for (const char* name : { "texts.tcview", "texts.html" })
  {
    StopAt listener(scene.Writer, -1);
    const std::string path = folder / name;
    Expect(
      scene.Write(path) && listener.IsRising && listener.Done == 1.0, "written: " + scene.Said());
    Expect(
      scene.Writer->GetBytesWritten() == static_cast<vtkIdType>(BytesOf(path).size()), "bytes");
    Expect(scene.View->Read(path.c_str()), "read: " + scene.Said());
    Expect(scene.View->GetTitle() == title && scene.View->GetCaption() == caption &&
        scene.View->GetCitation() == citation && scene.View->GetUnits() == units,
      std::string(name) + ": texts are as they were");
    Expect(scene.View->GetNumberOfViews() == 4 &&
        scene.View->GetViewName(1) == std::string("View 2") &&
        scene.View->GetViewName(3) == std::string("</script> \xc3\xa4"),
      std::string(name) + ": names");
    headers[kind++] = scene.View->GetHeader();
  }
  Expect(headers[0] == headers[1] && headers[0].size() > 1000, "both hold the same");
  const std::string page = BytesOf(folder / "texts.html");
  Expect(page.find(caption) == std::string::npos && page.find("x()</") == std::string::npos &&
      page.find("<b>") == std::string::npos && page.find("<!-- <") == std::string::npos,
    "texts are no markup");
  Expect(
    page.find("&lt;/script&gt;&lt;script&gt;x()") != std::string::npos, "the caption is there");
  Expect(page.find("@TITLE@&lt;/b&gt;") != std::string::npos, "marks in texts stay");
}

/// Each view of an orbit is that of its camera.
void TestOrbit(const ScratchFolder& folder)
{
  ViewScene scene(Volumes::FourSpheres(24));
  scene.Writer->SetRange(50.0, 150.0);
  scene.Writer->AddOrbit(3, scene.Renderer);
  const std::string path = folder / "orbit.tcview";
  Expect(scene.Write(path) && scene.View->Read(path.c_str()), "orbit: " + scene.Said());
  vtkNew<vtkImageData> found;
  for (int view = 0; view < 3; ++view)
  {
    Expect(scene.View->LookUp(view, 100.0, found) && scene.Render(24, 16), "looked up");
    const auto* depth = static_cast<const float*>(found->GetScalarPointer());
    int hits = 0, other = 0;
    for (int pixel = 0; pixel < 24 * 16; ++pixel)
    {
      const float truth = scene.DepthAt(pixel % 24, pixel / 24);
      hits += std::isfinite(truth);
      other += std::isfinite(truth) != std::isfinite(depth[pixel]) ||
        (std::isfinite(truth) && std::abs(truth - depth[pixel]) > 0.11f);
    }
    Expect(hits > 20 && other <= 4,
      "view " + std::to_string(view) + " of an orbit: " + std::to_string(other) + " of " +
        std::to_string(hits));
    scene.Renderer->GetActiveCamera()->Azimuth(120.0);
    scene.Renderer->ResetCameraClippingRange();
  }
}

void TestStops(const ScratchFolder& folder)
{
  for (const char* name : { "stop.html", "stop.tcview", "stop.cdb" })
  {
    ViewScene scene(Volumes::FourSpheres(24));
    scene.Writer->SetNumberOfIsovalues(3);
    scene.Writer->AddOrbit(2, scene.Renderer);
    const std::string path = folder / name;
    const std::size_t before = folder.Count();
    for (int report = 0, isStopped = 1; isStopped && report < 1000; ++report)
    {
      StopAt stop(scene.Writer, report);
      const bool isWritten = scene.Write(path);
      isStopped = stop.Done < 1.0;
      const std::string what = std::string(name) + ", report " + std::to_string(report);
      Expect(isWritten != static_cast<bool>(isStopped), what + ": tells of the stop");
      Expect(scene.Said().empty(), what + ": a stop is no error");
      Expect((folder.Count() == before) == static_cast<bool>(isStopped), what + ": files are left");
      Expect(isStopped || report > 3, what + ": some reports");
    }
    // What is there stays.
    const std::string file = name == std::string("stop.cdb") ? path + "/data.csv" : path;
    const std::string old = BytesOf(file);
    scene.Writer->SetTitle("Another");
    const std::size_t files = folder.Count();
    StopAt stop(scene.Writer, 2);
    Expect(!scene.Write(path) && BytesOf(file) == old && folder.Count() == files,
      std::string(name) + ": an old file stays");
  }
}

/// One error with a part of its sentence, and no file.
void ExpectRefused(const ScratchFolder& folder, const std::string& sentence, ViewScene& scene,
  const std::string& name = "refused.tcview")
{
  const std::size_t before = folder.Count();
  scene.Said();
  Expect(!scene.Write(folder / name), sentence + ": refused");
  const std::string said = scene.Said();
  Expect(said.find(sentence) != std::string::npos, sentence + ": but it says: " + said);
  Expect(folder.Count() == before, sentence + ": nothing is left");
}

void TestMistakes(const ScratchFolder& folder)
{
  const auto expect = [&](const std::string& sentence, const std::function<void(ViewScene&)>& spoil)
  {
    ViewScene scene(Volumes::FourSpheres(24));
    spoil(scene);
    ExpectRefused(folder, sentence, scene);
  };
  expect("mapper is a vtkTemporalCoherenceVolumeMapper",
    [](ViewScene& scene) { scene.Volume->SetMapper(nullptr); });
  expect("no input",
    [](ViewScene& scene) { scene.Mapper->SetInputData(static_cast<vtkImageData*>(nullptr)); });
  expect(
    "this volume is blended", [](ViewScene& scene) { scene.Mapper->SetBlendModeToComposite(); });
  expect("linear interpolation",
    [](ViewScene& scene) { scene.Volume->GetProperty()->SetInterpolationTypeToNearest(); });
  expect("crop to one box",
    [](ViewScene& scene)
    {
      scene.Mapper->CroppingOn();
      scene.Mapper->SetCroppingRegionPlanes(5.0, 9.0, 5.0, 9.0, 5.0, 9.0);
      scene.Mapper->SetCroppingRegionFlagsToCross();
    });
  expect("but samples lie from", [](ViewScene& scene) { scene.Writer->SetRange(1000.0, 2000.0); });
  for (const char* name : { "refused", "refused.png", "refused.tcview.txt", "" })
  {
    ViewScene scene(Volumes::FourSpheres(24));
    ExpectRefused(folder, "a path that ends in .html, .tcview or .cdb", scene, name);
  }
  WriteBytes(folder / "file", "");
  for (const char* name :
    { "none/refused.tcview", "none/refused.html", "file/refused.tcview", "file/refused.cdb" })
  {
    ViewScene scene(Volumes::FourSpheres(24));
    ExpectRefused(folder, "cannot be ", scene, name);
  }
  std::filesystem::create_directories(folder / "folder.tcview/inside");
  std::filesystem::create_directories(folder / "other.cdb");
  ViewScene scene(Volumes::FourSpheres(24));
  ExpectRefused(folder, "cannot be replaced", scene, "folder.tcview");
  ExpectRefused(folder, "is no Cinema database", scene, "other.cdb");
  Expect(!scene.Writer->WriteView(nullptr, scene.Renderer, scene.Volume) &&
      !scene.Writer->WriteView("a.html", nullptr, scene.Volume) &&
      !scene.Writer->WriteView("a.html", scene.Renderer, nullptr),
    "null is refused");
  scene.Said();
  scene.Writer->AddView("name", nullptr);
  Expect(scene.Said().find("needs a camera") != std::string::npos, "no camera");
  for (const int count : { 0, -1, 65 })
  {
    scene.Writer->AddOrbit(count, scene.Renderer);
    Expect(scene.Said().find("1 to 64 views") != std::string::npos, "no such orbit");
  }
  scene.Writer->AddOrbit(2, nullptr);
  Expect(!scene.Said().empty() && scene.Writer->GetNumberOfViews() == 0, "no renderer");
}

void TestReading(const ScratchFolder& folder)
{
  ViewScene scene(Volumes::FourSpheres(24));
  vtkNew<vtkImageData> image;
  const auto expectNone = [&](const std::string& sentence, const char* path)
  {
    Expect(!scene.View->Read(path), sentence + ": refused");
    const std::string said = scene.Said();
    Expect(said.find(sentence) != std::string::npos, sentence + ": but it says: " + said);
  };
  expectNone("cannot be read", nullptr);
  expectNone("cannot be read", (folder / "nothing.tcview").c_str());
  WriteBytes(folder / "page.html", "<!DOCTYPE html>\n<p>Nothing</p>");
  expectNone("holds no view file", (folder / "page.html").c_str());
  WriteBytes(folder / "page.html", "<!DOCTYPE html>\n<script id=\"view-file\">!</script>");
  expectNone("holds no view file", (folder / "page.html").c_str());
  WriteBytes(folder / "text.tcview", "no view");
  expectNone("does not begin with TCVIEW", (folder / "text.tcview").c_str());
  double range[2];
  int size[2];
  scene.View->GetRange(0, range);
  scene.View->GetSize(0, size);
  Expect(scene.View->GetNumberOfViews() == 0 && range[0] == 1.0 && range[1] == 0.0 &&
      size[0] == 0 && *scene.View->GetViewName(0) == 0 && *scene.View->GetTitle() == 0,
    "nothing is known before");
  Expect(!scene.View->LookUp(0, 100.0, image) && !scene.Said().empty(), "no view to look up");
  const std::string path = folder / "read.html", whole = folder / "read.tcview";
  Expect(scene.Write(path) && scene.Write(whole) && scene.View->Read(whole.c_str()), "read");
  for (const std::string& each : { path, whole })
  {
    const std::string bytes = BytesOf(each);
    for (std::size_t length = 0; length < bytes.size(); length += 1000)
    {
      // A page may end behind its data.
      WriteBytes(folder / "cut", bytes.substr(0, length));
      const bool isWhole =
        each == path && bytes.find('<', bytes.find("id=\"view-file\">")) < length;
      Expect(
        scene.View->Read((folder / "cut").c_str()) == isWhole && scene.Said().empty() == isWhole,
        each + " cut at " + std::to_string(length));
    }
  }
  Expect(scene.View->GetNumberOfViews() == 1, "the view before is kept");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double isovalue : { -1e9, 1e9, nan })
  {
    Expect(!scene.View->LookUp(0, isovalue, image), "no such isovalue");
    Expect(scene.Said().find("holds isovalues from") != std::string::npos, "says so");
  }
  Expect(!scene.View->LookUp(1, 100.0, image) && !scene.View->LookUp(-1, 100.0, image) &&
      !scene.View->LookUp(0, 100.0, nullptr),
    "no such view, or no image");
}

void TestSettings()
{
  ViewScene scene(nullptr);
  vtkTemporalCoherenceViewWriter* const writer = scene.Writer;
  writer->SetTolerance(0.0);
  Expect(writer->GetTolerance() == 0.02, "tolerance, clamped");
  writer->SetTolerance(99.0);
  Expect(writer->GetTolerance() == 10.0, "tolerance, clamped");
  writer->SetSize(0, 99999);
  Expect(writer->GetSize()[0] == 1 && writer->GetSize()[1] == 16384, "size, clamped");
  writer->SetNumberOfIsovalues(1);
  Expect(writer->GetNumberOfIsovalues() == 2, "number, clamped");
  writer->SetTitle("T");
  const auto before = writer->GetMTime();
  writer->SetTitle("T");
  Expect(writer->GetMTime() == before, "no change");
  writer->SetTitle(nullptr);
  Expect(*writer->GetTitle() == 0 && writer->GetMTime() > before, "null is no text");
  std::ostringstream text;
  writer->Print(text);
  scene.View->Print(text);
  for (const char* name : { "Tolerance: 10", "Size: 1, 16384", "NumberOfIsovalues: 2",
         "Title: ", "NumberOfViews: 0", "AbortExecute: 0" })
  {
    Expect(text.str().find(name) != std::string::npos, std::string(name) + " is printed");
  }
}

}

int TestViewWrite(int, char*[])
{
  // The Debug driver traps operations on what is not a number, which is what is tested here.
  vtkFloatingPointExceptions::Disable();
  const ScratchFolder folder;
  TestTexts(folder);
  TestOrbit(folder);
  TestStops(folder);
  TestMistakes(folder);
  TestReading(folder);
  TestSettings();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
