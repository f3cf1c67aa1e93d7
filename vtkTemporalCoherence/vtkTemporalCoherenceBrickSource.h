// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherenceBrickSource
 * @brief   an image that is larger than memory: its samples are read when they are needed
 *
 * A picture of an isosurface needs few samples of a volume. This source gives an image whose
 * samples stay in a file, or behind a reader of VTK. Connect a
 * vtkTemporalCoherenceVolumeMapper to it as to any other source (or call the mapper's
 * SetBrickSource). The mapper reads the parts of the volume that its rays meet, and keeps those in
 * memory that were needed last. Pictures are the same as of the whole volume in memory.
 *
 * SetFileName() takes
 * - a folder of OME-Zarr (NGFF 0.4 and 0.5) or a Zarr array,
 * - an HDF5 file of Imaris (.ims), of BigDataViewer (.h5), or with one data set,
 * - MetaImage (.mhd, .mha), NRRD (.nrrd, .nhdr) and .vti files whose data are raw and not
 *   compressed. These are mapped into memory if their byte order is this machine's. Then the
 *   operating system keeps what was read in its page cache, and memory of the program holds none of
 *   it.
 * - any other file if SetRawLayout() was called: raw samples.
 *
 * SetReader() takes any other reader of VTK that can give a part of its image (it honours
 * UPDATE_EXTENT): series of TIFF files, for example, or a vtkPythonAlgorithm.
 *
 * The first opening reads the volume once, and writes the value ranges of its blocks into a file
 * beside it, or into the user's folder for caches if that is not allowed. ProgressEvent tells how
 * far it is, and AbortExecute stops it. The next opening finds this file, and takes no time. The
 * file belongs to one state of the volume: if the size, the modification time or some samples
 * differ, it is made anew.
 *
 * Samples that cannot be read count as zeros, and each mapper reports an error that names the file.
 *
 * Other filters of VTK can use the image, too, but read the whole volume. Without a mapped
 * file, filters get values one by one, or a copy of all samples.
 *
 * @sa vtkTemporalCoherenceVolumeMapper
 */

#ifndef vtkTemporalCoherenceBrickSource_h
#define vtkTemporalCoherenceBrickSource_h

#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer
#include "vtkTemporalCoherenceCompatibility.h"
#include "vtkTemporalCoherenceModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string

VTK_ABI_NAMESPACE_BEGIN

class VTKTEMPORALCOHERENCE_EXPORT vtkTemporalCoherenceBrickSource : public vtkImageAlgorithm
{
public:
  static vtkTemporalCoherenceBrickSource* New();
  vtkTypeMacro(vtkTemporalCoherenceBrickSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set/Get the file or the folder of the volume (default: empty). A reader takes precedence over
   * it.
   */
  virtual void SetFileName(const std::string& name);
  std::string GetFileName() const { return this->FileName; }
  //@}

  //@{
  /**
   * Set/Get a reader that gives parts of an image (default: null). Its image must have one
   * component. After changes of the reader call Modified() of this source.
   */
  virtual void SetReader(vtkAlgorithm* reader);
  vtkAlgorithm* GetReader();
  //@}

  /**
   * Say how a file of raw samples is laid out. It counts for files whose name tells no format.
   * @param dimensions   samples along x, y and z; x is fastest
   * @param scalarType   VTK's number of the type, for example VTK_UNSIGNED_CHAR
   * @param headerSize   bytes before the first sample
   * @param isBigEndian  true if the bytes of a sample begin with the highest one
   */
  virtual void SetRawLayout(
    const int dimensions[3], int scalarType, vtkTypeInt64 headerSize = 0, bool isBigEndian = false);
  /** The same, with the samples along x, y and z one by one. */
  void SetRawLayout(
    int x, int y, int z, int scalarType, vtkTypeInt64 headerSize = 0, bool isBigEndian = false);

  //@{
  /**
   * Set/Get the distance of samples along each axis, and the place of the first sample, for raw
   * samples (defaults: 1 and 0).
   */
  vtkSetVector3Macro(RawSpacing, double);
  vtkGetVector3Macro(RawSpacing, double);
  vtkSetVector3Macro(RawOrigin, double);
  vtkGetVector3Macro(RawOrigin, double);
  //@}

  //@{
  /**
   * Set/Get which volume to take of a file with several: its channel and its point in time, from 0
   * (defaults: 0), and the name of a data set or of a reader's array (default: empty, the first
   * one).
   */
  vtkSetMacro(Channel, int);
  vtkGetMacro(Channel, int);
  vtkSetMacro(TimePoint, int);
  vtkGetMacro(TimePoint, int);
  virtual void SetArrayName(const std::string& name);
  std::string GetArrayName() const { return this->ArrayName; }
  //@}

  //@{
  /**
   * Set/Get the level of resolution, if a file has several: 0 (default) is the finest.
   */
  vtkSetClampMacro(Level, int, 0, VTK_INT_MAX);
  vtkGetMacro(Level, int);
  //@}

  //@{
  /**
   * Set/Get the bytes of memory that samples may take, from 1 MiB on (default: 1.5 GiB, so that a
   * program with one volume and its pictures stays below 2 GiB). Mapped files take none. A tile of
   * a picture may need more bytes: the limit is exceeded then. It can be changed at any time.
   */
  virtual void SetMemoryLimit(vtkTypeInt64 bytes);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  //@}

  //@{
  /**
   * Set/Get the folder for files with value ranges. Empty (default): the folder of the volume, or
   * else the user's folder for caches ($XDG_CACHE_HOME/vtkTemporalCoherence). If no file can be
   * written the ranges stay in memory, and the next opening finds them anew.
   */
  virtual void SetRangesFolder(const std::string& folder);
  std::string GetRangesFolder() const { return this->RangesFolder; }
  //@}

  //@{
  /**
   * Get the number of levels of resolution, and the samples of one along each axis. Call
   * UpdateInformation() before. 0 if there is no volume.
   */
  int GetNumberOfLevels();
  void GetLevelDimensions(int level, int dimensions[3]);
  //@}

  /**
   * Get a small image in memory that tells what the volume holds, for histograms and overviews: a
   * coarser level of at most four million samples, or else the middles of the value ranges of
   * blocks. It lies where the volume lies. Call Update() before. Null: the volume itself is small,
   * or missing.
   */
  vtkImageData* GetCoarseImage();

  /**
   * Get the bytes of memory that hold samples now. Mapped files take none.
   */
  vtkTypeInt64 GetMemoryInUse();

  /**
   * Get how often a brick was read since the volume was opened. 0 of mapped files.
   */
  vtkTypeInt64 GetNumberOfReads();

  /**
   * Get whether the samples are mapped into memory from a file. Call Update() before.
   */
  bool GetIsMapped();

  /**
   * Get whether the value ranges came from their file, at the last opening. Call Update() before.
   */
  bool GetHadRanges();

  /**
   * Forget the volume and free its memory. The next update opens it again.
   */
  virtual void Close();

protected:
  vtkTemporalCoherenceBrickSource();
  ~vtkTemporalCoherenceBrickSource() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

  std::string FileName, ArrayName, RangesFolder;
  int RawDimensions[3] = { 0, 0, 0 };
  int RawScalarType = VTK_UNSIGNED_CHAR;
  vtkTypeInt64 RawHeaderSize = 0;
  bool RawIsBigEndian = false;
  double RawSpacing[3] = { 1.0, 1.0, 1.0 };
  double RawOrigin[3] = { 0.0, 0.0, 0.0 };
  int Channel = 0;
  int TimePoint = 0;
  int Level = 0;
  vtkTypeInt64 MemoryLimit;

private:
  vtkTemporalCoherenceBrickSource(const vtkTemporalCoherenceBrickSource&) = delete;
  void operator=(const vtkTemporalCoherenceBrickSource&) = delete;

  class Internals;
  std::unique_ptr<Internals> Inner;
};

VTK_ABI_NAMESPACE_END
#endif
