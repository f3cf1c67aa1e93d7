// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// View files are read as they were written. Files that are cut, damaged, of another version, or
// with impossible numbers are refused with a sentence, and no small file takes much memory.

#include "FileParts.h"
#include "ViewTesting.h"

#include <nlohmann/json.hpp>

#include <cctype>
#include <fstream>

namespace
{

using namespace TemporalCoherence;
using Json = nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

std::string ErrorOf(const Bytes& file)
{
  LoadedViews views;
  return ReadViews(file, views);
}

/// An error is a sentence.
bool IsSentence(const std::string& text)
{
  return text.size() > 10 && std::isupper(static_cast<unsigned char>(text.front())) &&
    text.back() == '.';
}

TEST(ViewFile, IsReadAsItWasWritten)
{
  ViewFileMaker maker;
  std::vector<MadeView> made;
  for (const bool isInside : { false, true })
  {
    MadeViewSettings settings;
    settings.Size = isInside ? glm::ivec2(31, 77) : glm::ivec2(24, 16);
    settings.IsInside = settings.HasHoles = isInside;
    made.push_back(MakeView(settings));
    maker.Add(made.back().Geometry, made.back().Knots);
  }
  LoadedViews views;
  ASSERT_EQ(ReadViews(maker.Finish(MakeDescription()), views), "");
  ASSERT_EQ(views.Knots.size(), 2u);
  EXPECT_TRUE(made[0].Knots.Unknown.empty());
  EXPECT_FALSE(made[1].Knots.Entries.empty() || made[1].Knots.Unknown.empty());
  for (std::size_t view = 0; view < 2; ++view)
  {
    const KnotImage &read = views.Knots[view], &image = made[view].Knots;
    for (std::size_t direction = 0; direction < NumberOfDirections; ++direction)
    {
      ExpectSame(read.Knots[direction], image.Knots[direction]);
      EXPECT_EQ(views.Header.Views[view].Knots[direction], image.Knots[direction].Progress.size());
    }
    EXPECT_EQ(read.Entries, image.Entries);
    EXPECT_EQ(read.Unknown, image.Unknown);
    EXPECT_EQ(read.Size, image.Size);
    EXPECT_EQ(read.Values.Low, image.Values.Low);
    EXPECT_EQ(read.Values.High, image.Values.High);
    EXPECT_EQ(read.Grid.ProgressStep, image.Grid.ProgressStep);
    EXPECT_EQ(read.Grid.DistanceStep, image.Grid.DistanceStep);
    EXPECT_EQ(read.Grid.LargestProgress, image.Grid.LargestProgress);
    EXPECT_EQ(read.NormalSteps, image.NormalSteps);
    const ViewGeometry& geometry = views.Header.Views[view].Geometry;
    EXPECT_EQ(geometry.Rays.Origin, made[view].Geometry.Rays.Origin);
    EXPECT_EQ(geometry.Rays.DirectionX, made[view].Geometry.Rays.DirectionX);
    EXPECT_EQ(geometry.Box.High, made[view].Geometry.Box.High);
  }
  const ViewDescription& read = views.Header.Description;
  const ViewDescription written = MakeDescription();
  EXPECT_EQ(read.Texts.Caption, written.Texts.Caption);
  EXPECT_EQ(read.Look.Surfaces[1].Color, written.Look.Surfaces[1].Color);
  EXPECT_EQ(read.Look.Colors, written.Look.Colors);
  EXPECT_EQ(read.Look.Background2, written.Look.Background2);
  EXPECT_EQ(read.Histogram.Counts, written.Histogram.Counts);
}

TEST(ViewFile, CutFilesAreRefused)
{
  const Bytes file = MakeFile();
  ASSERT_EQ(ErrorOf(file), "");
  for (std::size_t length = 0; length < file.size(); length += length < 200 ? 1 : 37)
  {
    const Bytes cut(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(length));
    EXPECT_TRUE(IsSentence(ErrorOf(cut))) << length << ErrorOf(cut);
  }
}

/// Each byte is under a checksum, but those without a meaning: reserved ones, and the bits that
/// fill up the last byte of a compressed part.
TEST(ViewFile, DamagedBytesAreRefused)
{
  const Bytes file = MakeFile();
  LoadedViews good;
  ASSERT_EQ(ReadViews(file, good), "");
  std::size_t harmless = 0;
  for (std::size_t at = 0; at < file.size(); ++at)
  {
    Bytes damaged = file;
    damaged[at] ^= static_cast<std::uint8_t>(1u << (at % 8));
    LoadedViews views;
    const std::string error = ReadViews(damaged, views);
    harmless += error.empty();
    EXPECT_TRUE(error.empty() || IsSentence(error)) << at << error;
    for (std::size_t view = 0; error.empty() && view < 2; ++view)
    {
      ExpectSame(views.Knots[view].Knots[0], good.Knots[view].Knots[0]);
      ExpectSame(views.Knots[view].Knots[1], good.Knots[view].Knots[1]);
    }
  }
  EXPECT_LE(harmless, 4u + 10u);
}

TEST(ViewFile, OtherFilesAndVersionsAreRefused)
{
  Bytes file = MakeFile();
  file[8] = 2;
  EXPECT_EQ(ErrorOf(file), "This view file has version 2; only version 1 can be read.");
  file[0] = 'X';
  EXPECT_EQ(ErrorOf(file), "This is no view file: it does not begin with TCVIEW.");
  FileParts parts(MakeFile());
  parts.Header = "[1, 2";
  EXPECT_TRUE(IsSentence(ErrorOf(parts.Join())));
  Json header = Json::parse(FileParts(MakeFile()).Header);
  header["version"] = 2;
  parts.Header = header.dump();
  EXPECT_NE(ErrorOf(parts.Join()).find("another format or version"), std::string::npos);
}

/// A place in the header, what stands there, and a part of the sentence about it.
struct Impossible
{
  const char *Place, *Value, *Sentence;
};

TEST(ViewFile, ImpossibleNumbersAreRefused)
{
  const Impossible all[] = { { "/views/0/size/0", "0", "out of range" },
    { "/views/0/size/0", "16385", "out of range" }, { "/views/0/size/0", "24.5", "out of range" },
    { "/views/0/size/0", "\"24\"", "number" }, { "/views/0/size", "[24]", "" },
    { "/views/0/range", "[2, 1]", "before it begins" },
    { "/views/0/progress/largest", "65536", "out of range" },
    { "/views/0/progress/largest", "10", "a knot is impossible" },
    { "/views/0/progress/step", "0", "not above 0" }, { "/views/0/progress/margin", "5", "margin" },
    { "/views/0/distanceStep", "-1", "not above 0" },
    { "/views/0/normalSteps", "128", "out of range" },
    { "/views/0/knots/rising", "1", "do not hold the knots" },
    { "/views/0/knots/rising", "1e30", "out of range" },
    { "/views/0/knots/rising", "-1", "out of range" },
    { "/views/0/chunks", "[]", "do not hold the knots" },
    { "/views/0/chunks/0/offset", "1e300", "out of range" },
    { "/views/0/chunks/0/offset", "-1", "out of range" },
    { "/views/0/chunks/0/offset", "900000", "ends before a section" },
    { "/views/0/chunks/0/bytes", "900000", "ends before a section" },
    { "/views/0/chunks/0/bytes", "18446744073709551615", "out of range" },
    { "/views/0/chunks/0/unpacked", "900000000000", "as large as it says" },
    { "/views/0/chunks/0/unpacked", "100", "too small for its knots" },
    { "/views/0/chunks/0/direction", "\"up\"", "neither rising nor falling" },
    { "/views/0/chunks/0/rows", "17", "out of range" },
    { "/views/0/chunks/0/rows", "15", "Chunk 0 is damaged" },
    { "/views/1/entries/unpacked", "2", "another size" },
    { "/views/1/unknown/unpacked", "47", "another size" },
    { "/views/0/box/matrix", "[0,0,0,0, 0,0,0,0, 0,0,0,0, 0,0,0,0]", "no inverse" },
    { "/views/0/box/low", "[1, 0, 0]", "a box" }, { "/views/0/box/high", "[0, 3, 3]", "a box" },
    { "/views/0/box/high", "[1e300, 3, 3]", "a box" },
    { "/views/0/box/high", "[2.5, 3, 3]", "a box" },
    { "/views/0/rays/origin", "[1e999, 0, 0]", "" }, { "/views", "[]", "no view" },
    { "/views", "{}", "no view" }, { "/surfaces", "[]", "no surface" },
    { "/histogram/counts", "[1e300]", "out of range" }, { "/title", "5", "" } };
  const FileParts good(MakeFile());
  for (const Impossible& each : all)
  {
    SCOPED_TRACE(std::string(each.Place) + ": " + each.Value);
    Json header = Json::parse(good.Header);
    const Json::json_pointer place(each.Place);
    ASSERT_TRUE(header.contains(place));
    // A number that is no double stands in the text only.
    header[place] = "@";
    FileParts parts = good;
    parts.Header = header.dump();
    parts.Header.replace(parts.Header.find("\"@\""), 3, each.Value);
    const std::string error = ErrorOf(parts.Join());
    EXPECT_TRUE(IsSentence(error)) << error;
    EXPECT_NE(error.find(each.Sentence), std::string::npos) << error;
  }
}

TEST(ViewFile, EachKeyIsNeeded)
{
  const FileParts good(MakeFile());
  const Json header = Json::parse(good.Header);
  const auto isOptional = [](const std::string& name)
  {
    return name == "histogram" || name == "colors" || name == "background2" || name == "planes" ||
      name == "entries" || name == "unknown";
  };
  int removed = 0;
  const auto remove = [&](const Json::json_pointer& place)
  {
    const Json object = header.at(place);
    for (const auto& [name, value] : object.items())
    {
      Json without = header;
      without[place].erase(name);
      FileParts parts = good;
      parts.Header = without.dump();
      EXPECT_EQ(ErrorOf(parts.Join()).empty(), isOptional(name)) << place << '/' << name;
      ++removed;
    }
  };
  for (const char* place : { "", "/material", "/lights/0", "/surfaces/0", "/histogram", "/views/0",
         "/views/1", "/views/0/camera", "/views/0/rays", "/views/0/box", "/views/0/progress",
         "/views/0/chunks/0", "/views/0/knots" })
  {
    remove(Json::json_pointer(place));
  }
  EXPECT_GT(removed, 80);
}

/// A file of few bytes cannot ask for the memory of many chunks by naming the same bytes again.
TEST(ViewFile, SectionsDoNotOverlap)
{
  FileParts parts(MakeFile());
  Json header = Json::parse(parts.Header);
  Json& view = header["views"][0];
  view["size"][1] = 32;
  view.erase("entries");
  Json again = view["chunks"][0];
  again["first"] = 16;
  view["chunks"].push_back(again);
  ASSERT_EQ(again["direction"], "rising");
  view["knots"]["rising"] = 2 * view["knots"]["rising"].get<int>();
  // With all bytes of the file named once, these are too many.
  parts.Header = header.dump();
  EXPECT_NE(ErrorOf(parts.Join()).find("sections overlap"), std::string::npos);
}

/// For tests of the page's scripts, a file in the present folder.
TEST(ViewFile, IsLeftForScripts)
{
  const Bytes file = MakeFile();
  std::ofstream stream("left.tcview", std::ios::binary);
  stream.write(
    reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
  EXPECT_TRUE(stream.flush());
}

TEST(ViewFile, TooManyPixelsAreRefused)
{
  FileParts parts(MakeFile());
  Json header = Json::parse(parts.Header);
  Json view = header["views"][0];
  view["size"] = { 16384, 4096 };
  view["chunks"] = Json::array();
  view.erase("entries");
  view["knots"] = { { "rising", 0 }, { "falling", 0 } };
  header["views"] = { view, view };
  parts.Header = header.dump();
  EXPECT_NE(ErrorOf(parts.Join()).find("too many pixels"), std::string::npos);
}

}
