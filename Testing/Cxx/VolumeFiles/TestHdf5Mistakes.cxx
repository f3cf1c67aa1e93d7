// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// HDF5 files that are damaged, or that hold what cannot be read, are refused with a sentence. Links
// to other files are not followed.

#include "Mutations.h"
#include "ReadBack.h"
#include "VolumeFiles/Hdf5Volume.h"
#include "VolumeFiles/Hdf5Writer.h"

#include <fstream>
#include <random>

using namespace ReadBack;

namespace
{

Hdf5Plan SmallPlan(Hdf5Layout layout = Hdf5Layout::DataSet)
{
  Hdf5Plan plan;
  plan.Layout = layout;
  plan.Type = ScalarType::UInt16;
  plan.Dimensions = { { 24, 20, 12 } };
  plan.Factors = { { 1, 1, 1 } };
  plan.Chunk = { 8, 8, 4 };
  plan.Deflate = 4;
  plan.IsShuffled = true;
  return plan;
}

void Write(const std::string& path, const Hdf5Plan& plan)
{
  Hdf5Writer writer(path, plan);
  VolumeLevel level;
  level.Dimensions = plan.Dimensions[0];
  level.Chunk = plan.Chunk;
  for (const glm::ivec3& chunk : ChunksOf(level))
  {
    const auto samples =
      MakeChunk<std::uint16_t>(0, chunk * level.Chunk, level.Chunk, level.Dimensions);
    writer.WriteChunk(0, chunk, samples.data());
  }
  ASSERT_TRUE(writer.IsGood());
}

/// Expect that a file is refused with a sentence that names it and has a part.
void ExpectRefusal(const std::string& path, const std::string& part, const std::string& array = "")
{
  VolumeChoice choice;
  choice.Array = array;
  std::string error;
  EXPECT_FALSE(OpenHdf5(path, choice, error)) << part;
  EXPECT_NE(error.find(part), std::string::npos) << error;
  EXPECT_NE(error.find(path), std::string::npos) << error;
}

/// A file to which a test adds what it needs.
struct NewFile
{
  explicit NewFile(const std::string& path)
    : Id(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT))
  {
  }
  ~NewFile() { H5Fclose(this->Id); }
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  /// Add a data set that is never written.
  void Add(
    const char* name, hid_t type, const std::vector<hsize_t>& sizes, hid_t properties = H5P_DEFAULT)
  {
    const hid_t space = H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr);
    const hid_t data =
      H5Dcreate2(this->Id, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    EXPECT_GE(data, 0);
    H5Dclose(data);
    H5Sclose(space);
  }

  hid_t Id;
};

std::string ReadBytes(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

void WriteBytes(const std::string& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

/// Bytes in a file that are restored at the end.
class ChangedBytes
{
public:
  ChangedBytes(const std::string& path, std::size_t place, const std::string& bytes)
    : File(path, std::ios::binary | std::ios::in | std::ios::out)
    , Place(static_cast<std::streamoff>(place))
    , Before(bytes.size(), ' ')
  {
    this->File.seekg(this->Place);
    this->File.read(&this->Before[0], static_cast<std::streamsize>(bytes.size()));
    this->Put(bytes);
  }
  ~ChangedBytes() { this->Put(this->Before); }
  ChangedBytes(const ChangedBytes&) = delete;
  ChangedBytes& operator=(const ChangedBytes&) = delete;

private:
  void Put(const std::string& bytes)
  {
    this->File.seekp(this->Place);
    this->File.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    this->File.flush();
  }

  std::fstream File;
  std::streamoff Place;
  std::string Before;
};

/// Where the chunks of the data set lie in the file.
std::vector<std::pair<std::size_t, std::size_t>> StoredChunks(const std::string& path)
{
  std::vector<std::pair<std::size_t, std::size_t>> stored;
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t data = H5Dopen2(file, "/volume", H5P_DEFAULT);
  hsize_t count = 0;
  const hid_t space = H5Dget_space(data);
  H5Dget_num_chunks(data, space, &count);
  for (hsize_t i = 0; i < count; ++i)
  {
    hsize_t offset[3], size = 0;
    haddr_t address = 0;
    unsigned mask = 0;
    H5Dget_chunk_info(data, space, i, offset, &mask, &address, &size);
    stored.emplace_back(address, size);
  }
  H5Sclose(space);
  H5Dclose(data);
  H5Fclose(file);
  return stored;
}

}

TEST(Hdf5Mistakes, AreToldWithoutAFile)
{
  const std::string folder = Folder("vtkTemporalCoherenceHdf5Mistakes");
  ExpectRefusal(folder + "missing.h5", "cannot be opened as HDF5");
  WriteBytes(folder + "text.h5", "This is not HDF5.");
  ExpectRefusal(folder + "text.h5", "cannot be opened as HDF5");
  WriteBytes(folder + "empty.h5", "");
  ExpectRefusal(folder + "empty.h5", "cannot be opened as HDF5");
}

TEST(Hdf5Mistakes, InTruncatedFilesAreTold)
{
  const std::string folder = Folder("vtkTemporalCoherenceHdf5Mistakes");
  Write(folder + "whole.h5", SmallPlan());
  const std::string bytes = ReadBytes(folder + "whole.h5");
  for (std::size_t size = 0; size < bytes.size(); size += 97)
  {
    const std::string path = folder + "part" + std::to_string(size) + ".h5";
    WriteBytes(path, bytes.substr(0, size));
    ExpectRefusal(path, "cannot be opened as HDF5");
  }
}

TEST(Hdf5Mistakes, InTheChoiceOfADataSetAreTold)
{
  const std::string path = Folder("vtkTemporalCoherenceHdf5Mistakes") + "choice.h5";
  {
    NewFile file(path);
  }
  ExpectRefusal(path, "no data set of three dimensions");
  {
    NewFile file(path);
    H5Gclose(H5Gcreate2(file.Id, "group", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    file.Add("flat", H5T_NATIVE_INT, { 4, 4 });
    file.Add("text", H5T_C_S1, { 2, 2, 2 });
    file.Add("volume", H5T_NATIVE_INT, { 4, 4, 4 });
  }
  std::string error;
  EXPECT_TRUE(OpenHdf5(path, {}, error)) << error;
  ExpectRefusal(path, "is missing", "other");
  ExpectRefusal(path, "is no data set", "group");
  ExpectRefusal(path, "three dimensions", "flat");
  ExpectRefusal(path, "8 to 64 bits", "text");
  {
    NewFile file(path);
    const hid_t group = H5Gcreate2(file.Id, "group", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    // A group in itself does not keep the search busy.
    H5Lcreate_hard(file.Id, "/group", group, "itself", H5P_DEFAULT, H5P_DEFAULT);
    H5Gclose(group);
    file.Add("group/one", H5T_NATIVE_INT, { 4, 4, 4 });
    file.Add("two", H5T_NATIVE_FLOAT, { 4, 4, 4 });
  }
  ExpectRefusal(path, "'/group/one'");
  VolumeChoice choice;
  choice.Array = "group/one";
  EXPECT_TRUE(OpenHdf5(path, choice, error)) << error;
}

TEST(Hdf5Mistakes, InTypesAndSizesAreTold)
{
  const std::string path = Folder("vtkTemporalCoherenceHdf5Mistakes") + "types.h5";
  const hid_t compound = H5Tcreate(H5T_COMPOUND, 8);
  H5Tinsert(compound, "one", 0, H5T_NATIVE_FLOAT);
  H5Tinsert(compound, "two", 4, H5T_NATIVE_FLOAT);
  const hid_t extended = H5Tcopy(H5T_NATIVE_LDOUBLE);
  const hid_t odd = H5Tcopy(H5T_NATIVE_INT);
  H5Tset_precision(odd, 17);
  H5Tset_size(odd, 3);
  const hid_t huge = H5Pcreate(H5P_DATASET_CREATE);
  const hsize_t chunk[3] = { 1024, 1024, 2048 };
  H5Pset_chunk(huge, 3, chunk);
  {
    NewFile file(path);
    file.Add("compound", compound, { 2, 2, 2 });
    file.Add("extended", extended, { 2, 2, 2 });
    file.Add("odd", odd, { 2, 2, 2 });
    file.Add("long", H5T_NATIVE_INT8, { 1, 1, hsize_t(1) << 31 });
    file.Add("none", H5T_NATIVE_INT8, { 1, 0, 1 });
    file.Add("chunks", H5T_NATIVE_INT8, { 2048, 2048, 2048 }, huge);
    file.Add("large", H5T_NATIVE_DOUBLE, { 300, 30000, 30000 });
  }
  H5Tclose(compound);
  H5Tclose(extended);
  H5Tclose(odd);
  H5Pclose(huge);
  for (const char* name : { "compound", "extended", "odd" })
  {
    ExpectRefusal(path, "8 to 64 bits", name);
  }
  ExpectRefusal(path, "2147483648 samples along an axis", "long");
  ExpectRefusal(path, "0 samples along an axis", "none");
  ExpectRefusal(path, "chunks of 2 GiB or more", "chunks");
  VolumeChoice choice;
  choice.Array = "large";
  std::string error;
  const auto volume = OpenHdf5(path, choice, error);
  ASSERT_TRUE(volume) << error;
  EXPECT_EQ(volume->Levels()[0].Chunk, glm::ivec3(30000, 17, 1));
}

TEST(Hdf5Mistakes, InImarisAttributesAreTold)
{
  const std::string path = Folder("vtkTemporalCoherenceHdf5Mistakes") + "attributes.ims";
  Write(path, SmallPlan(Hdf5Layout::Imaris));
  for (const char* wrong : { "99", "0 ", "-1" })
  {
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t group =
      H5Gopen2(file, "/DataSet/ResolutionLevel 0/TimePoint 0/Channel 0", H5P_DEFAULT);
    const hid_t size = H5Aopen(group, "ImageSizeX", H5P_DEFAULT);
    EXPECT_GE(H5Awrite(size, H5T_C_S1, wrong), 0);
    H5Aclose(size);
    H5Gclose(group);
    H5Fclose(file);
    ExpectRefusal(path, "'ImageSizeX'");
  }
}

TEST(Hdf5Mistakes, DoNotLeadOutOfTheFile)
{
  const std::string folder = Folder("vtkTemporalCoherenceHdf5Mistakes");
  const std::string other = folder + "other.h5", path = folder + "links.h5";
  Write(other, SmallPlan());
  const hid_t external = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_external(external, other.c_str(), 0, 64);
  const hid_t virtual_ = H5Pcreate(H5P_DATASET_CREATE);
  const hsize_t sizes[3] = { 12, 20, 24 };
  const hid_t space = H5Screate_simple(3, sizes, nullptr);
  H5Pset_virtual(virtual_, space, other.c_str(), "/volume", space);
  H5Sclose(space);
  {
    NewFile file(path);
    H5Lcreate_external(other.c_str(), "/volume", file.Id, "link", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_external(other.c_str(), "/", file.Id, "root", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_soft("/link", file.Id, "soft", H5P_DEFAULT, H5P_DEFAULT);
    file.Add("external", H5T_NATIVE_INT8, { 4, 4, 4 }, external);
    file.Add("virtual", H5T_NATIVE_UINT16, { 12, 20, 24 }, virtual_);
  }
  H5Pclose(external);
  H5Pclose(virtual_);
  for (const char* name : { "link", "soft", "root/volume" })
  {
    ExpectRefusal(path, "lies in another file", name);
  }
  ExpectRefusal(path, "keeps its samples in other files", "external");
  ExpectRefusal(path, "is virtual", "virtual");
}

TEST(Hdf5Mistakes, InFiltersAreTold)
{
  const std::string path = Folder("vtkTemporalCoherenceHdf5Mistakes") + "filter.h5";
  constexpr H5Z_filter_t id = 300; // of those that are free for tests
  H5Z_class2_t filter{};
  filter.version = H5Z_CLASS_T_VERS;
  filter.id = id;
  filter.encoder_present = filter.decoder_present = 1;
  filter.name = "none";
  filter.filter = [](unsigned, std::size_t, const unsigned*, std::size_t bytes, std::size_t*,
                    void**) { return bytes; };
  ASSERT_GE(H5Zregister(&filter), 0);
  const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
  const hsize_t chunk[3] = { 4, 4, 4 };
  H5Pset_chunk(properties, 3, chunk);
  H5Pset_filter(properties, id, H5Z_FLAG_MANDATORY, 0, nullptr);
  {
    NewFile file(path);
    file.Add("volume", H5T_NATIVE_INT, { 8, 8, 8 }, properties);
  }
  H5Pclose(properties);
  std::string error;
  EXPECT_TRUE(OpenHdf5(path, {}, error)) << error;
  H5Zunregister(id);
  ExpectRefusal(path, "filter 300");
}

TEST(Hdf5Mistakes, InChunksAreTold)
{
  const std::string path = Folder("vtkTemporalCoherenceHdf5Mistakes") + "damaged.h5";
  Write(path, SmallPlan());
  const std::string bytes = ReadBytes(path);
  const auto stored = StoredChunks(path);
  ASSERT_EQ(stored.size(), 27u);
  std::mt19937 random(5);
  int told = 0;
  const int trials = NumberOfMutations(3000);
  for (int trial = 0; trial < trials; ++trial)
  {
    const auto& [address, size] = stored[random() % stored.size()];
    std::string changed = bytes.substr(address, size);
    for (unsigned change = 0; change <= random() % 4; ++change)
    {
      changed[random() % size] = static_cast<char>(random());
    }
    const ChangedBytes change(path, address, changed);
    std::string error;
    const auto volume = OpenHdf5(path, {}, error);
    ASSERT_TRUE(volume) << error;
    std::vector<std::uint16_t> samples(volume->Levels()[0].SamplesOfChunk());
    for (const glm::ivec3& chunk : ChunksOf(volume->Levels()[0]))
    {
      std::string sentence;
      if (!volume->ReadChunk(0, chunk, samples.data(), sentence))
      {
        ++told;
        EXPECT_NE(sentence.find(path), std::string::npos) << sentence;
        EXPECT_NE(sentence.find("'/volume'"), std::string::npos) << sentence;
      }
      else
      {
        EXPECT_EQ(sentence, "");
      }
    }
  }
  EXPECT_GT(told, trials / 2); // the checksums of deflate find nearly all changes
}
