// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Volumes whose files become shorter or vanish while they are open do not end the program: their
// samples read as zero, and a sentence tells so. Faults and signals of others do what they did.

#include "RawFiles.h"

#include "VolumeFiles/MappedFile.h"
#include "VolumeFiles/RandomAccessFile.h"

#ifndef _WIN32

#include <atomic>
#include <csignal>
#include <thread>

#include <sys/mman.h>
#include <unistd.h>

using namespace TemporalCoherence;

namespace
{

constexpr int Side = 200;

std::unique_ptr<VolumeFile> OpenCube(const std::string& path)
{
  RawLayout layout;
  layout.Type = ScalarType::UInt8;
  layout.Dimensions = glm::ivec3(Side);
  WriteFile(path, std::string(std::size_t(Side) * Side * Side, 'x'));
  std::string error;
  std::unique_ptr<VolumeFile> file = OpenRaw(path, layout, error);
  EXPECT_TRUE(file) << error;
  return file;
}

std::size_t CountOf(const VolumeFile& file, char value)
{
  const auto* samples = static_cast<const char*>(file.MappedSamples(0));
  return static_cast<std::size_t>(
    std::count(samples, samples + std::size_t(Side) * Side * Side, value));
}

}

TEST(BrokenFiles, ShortenedMappingReadsAsZero)
{
  const ScratchFolder folder;
  const auto other = OpenCube(folder / "other.raw");
  const auto file = OpenCube(folder / "short.raw");
  std::string error;
  EXPECT_FALSE(file->HasFailed(error));
  constexpr std::size_t kept = 1000 * 4096;
  std::filesystem::resize_file(std::filesystem::u8path(folder / "short.raw"), kept);
  EXPECT_EQ(CountOf(*file, 'x'), kept);
  ASSERT_TRUE(file->HasFailed(error));
  ExpectSentence(error, "short.raw");
  EXPECT_EQ(CountOf(*other, 'x'), std::size_t(Side) * Side * Side);
  EXPECT_FALSE(other->HasFailed(error));
}

TEST(BrokenFiles, FaultsInAnyOrderAndManyThreads)
{
  const ScratchFolder folder;
  const auto file = OpenCube(folder / "empty.raw");
  std::filesystem::resize_file(std::filesystem::u8path(folder / "empty.raw"), 0);
  const auto* samples = static_cast<const char*>(file->MappedSamples(0));
  std::atomic<int> sum{ 0 };
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
  {
    threads.emplace_back(
      [&, t]
      {
        for (int page = Side * Side * Side / 4096; page >= 0; --page)
        {
          sum += samples[page * 4096 + t];
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(sum.load(), 0);
  std::string error;
  EXPECT_TRUE(file->HasFailed(error));
}

TEST(BrokenFiles, ReadChunkTellsOfShortenedFile)
{
  const ScratchFolder folder;
  const std::string path = folder / "chunks.raw";
  const auto file = OpenCube(path);
  std::vector<char> samples(file->Levels()[0].SamplesOfChunk());
  std::filesystem::resize_file(std::filesystem::u8path(path), 12345);
  std::string error;
  EXPECT_FALSE(file->ReadChunk(0, { 0, 0, 0 }, samples.data(), error));
  ExpectSentence(error, "chunks.raw");
}

TEST(BrokenFiles, DeletedFileCanBeRead)
{
  const ScratchFolder folder;
  const std::string path = folder / "deleted.raw";
  const auto file = OpenCube(path);
  std::filesystem::remove(std::filesystem::u8path(path));
  std::vector<char> samples(file->Levels()[0].SamplesOfChunk());
  std::string error;
  EXPECT_TRUE(file->ReadChunk(0, { 0, 0, 0 }, samples.data(), error)) << error;
  EXPECT_EQ(CountOf(*file, 'x'), std::size_t(Side) * Side * Side);
  EXPECT_FALSE(file->HasFailed(error));
}

TEST(BrokenFiles, ManyMappingsComeAndGo)
{
  const ScratchFolder folder;
  const std::string path = folder / "many.raw";
  WriteFile(path, std::string(10000, 'x'));
  std::string error;
  const auto file = RandomAccessFile::Open(path, error);
  ASSERT_TRUE(file) << error;
  for (int round = 0; round < 3; ++round)
  {
    // More than the list of guarded ranges holds: the last ones are not mapped.
    std::vector<std::unique_ptr<MappedFile>> mapped;
    for (int i = 0; i < 1000 && (mapped.empty() || mapped.back()); ++i)
    {
      mapped.push_back(MappedFile::Map(*file, 10000));
    }
    EXPECT_GT(mapped.size(), 100u);
    EXPECT_FALSE(mapped.back());
    EXPECT_EQ(mapped.front()->Data()[9999], std::byte('x'));
  }
  EXPECT_FALSE(MappedFile::Map(*file, 0));
  EXPECT_FALSE(MappedFile::Map(*file, 10001));
}

namespace
{

/// Read beyond the end of a file that is mapped by others than MappedFile.
void ReadForeignMapping(const ScratchFolder& folder)
{
  const std::string path = folder / "foreign.raw";
  WriteFile(path, std::string(100, 'x'));
  std::string error;
  const auto file = RandomAccessFile::Open(path, error);
  void* begin = ::mmap(nullptr, 8192, PROT_READ, MAP_SHARED, file->Descriptor(), 0);
  folder.Remove();
  volatile char read = static_cast<const volatile char*>(begin)[5000];
  static_cast<void>(read);
}

void ExitFromHandler(int /*signal*/)
{
  ::_exit(7);
}

void ExitFromLongHandler(int /*signal*/, siginfo_t* /*about*/, void* /*context*/)
{
  ::_exit(8);
}

}

// Each of these starts a new process, in which no handler of ours is installed yet.
class BrokenFilesDeathTest : public testing::Test
{
protected:
  void SetUp() override { testing::FLAGS_gtest_death_test_style = "threadsafe"; }

  const ScratchFolder Folder;
};

TEST_F(BrokenFilesDeathTest, ForeignFaultEndsProgramByDefault)
{
  EXPECT_EXIT(
    {
      std::signal(SIGBUS, SIG_DFL); // sanitizers have a handler
      const auto file = OpenCube(this->Folder / "ours.raw");
      ReadForeignMapping(this->Folder);
    },
    testing::KilledBySignal(SIGBUS), "");
}

TEST_F(BrokenFilesDeathTest, SentSignalEndsProgramByDefault)
{
  EXPECT_EXIT(
    {
      std::signal(SIGBUS, SIG_DFL);
      const auto file = OpenCube(this->Folder / "ours.raw");
      this->Folder.Remove();
      std::raise(SIGBUS);
    },
    testing::KilledBySignal(SIGBUS), "");
}

TEST_F(BrokenFilesDeathTest, IgnoredSignalIsIgnoredIfItIsNoFault)
{
  EXPECT_EXIT(
    {
      std::signal(SIGBUS, SIG_IGN);
      const auto file = OpenCube(this->Folder / "ours.raw");
      std::raise(SIGBUS);
      std::filesystem::resize_file(std::filesystem::u8path(this->Folder / "ours.raw"), 0);
      this->Folder.Remove();
      std::string error;
      ::_exit(
        CountOf(*file, 0) == std::size_t(Side) * Side * Side && file->HasFailed(error) ? 5 : 6);
    },
    testing::ExitedWithCode(5), "");
}

TEST_F(BrokenFilesDeathTest, ForeignFaultCallsEarlierHandlers)
{
  EXPECT_EXIT(
    {
      std::signal(SIGBUS, ExitFromHandler);
      const auto file = OpenCube(this->Folder / "ours.raw");
      ReadForeignMapping(this->Folder);
    },
    testing::ExitedWithCode(7), "");
  EXPECT_EXIT(
    {
      struct sigaction action = {};
      action.sa_sigaction = ExitFromLongHandler;
      action.sa_flags = SA_SIGINFO;
      ::sigaction(SIGBUS, &action, nullptr);
      const auto file = OpenCube(this->Folder / "ours.raw");
      ReadForeignMapping(this->Folder);
    },
    testing::ExitedWithCode(8), "");
}

#endif
