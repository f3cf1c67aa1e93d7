# Libraries that read formats of large volumes. Without them the module is built, and says that it
# cannot read these. Tests and the generator of volumes include this, too.
find_package(nlohmann_json QUIET)
find_package(ZLIB QUIET)
find_path(TEMPORAL_COHERENCE_BLOSC_INCLUDE_DIR blosc.h)
find_library(TEMPORAL_COHERENCE_BLOSC_LIBRARY blosc)
find_path(TEMPORAL_COHERENCE_ZSTD_INCLUDE_DIR zstd.h)
find_library(TEMPORAL_COHERENCE_ZSTD_LIBRARY zstd)
find_package(HDF5 QUIET COMPONENTS C)
mark_as_advanced(TEMPORAL_COHERENCE_BLOSC_INCLUDE_DIR TEMPORAL_COHERENCE_BLOSC_LIBRARY
  TEMPORAL_COHERENCE_ZSTD_INCLUDE_DIR TEMPORAL_COHERENCE_ZSTD_LIBRARY)

set(volume_format_files
  BusErrors
  MappedFile
  MetaImageVolume
  NrrdVolume
  RandomAccessFile
  RawLayout
  RawVolume
  SampleBytes
  VolumeHeader
  FileFacts
  ReaderErrors
  ReaderFiles
  ReaderOutput
  ReaderVolume
  VtiHeader
  VtiVolume
  VtkTypes)
set(volume_format_definitions)
set(volume_format_libraries)
set(volume_format_includes)
if (nlohmann_json_FOUND AND ZLIB_FOUND AND TEMPORAL_COHERENCE_BLOSC_LIBRARY AND
    TEMPORAL_COHERENCE_BLOSC_INCLUDE_DIR AND TEMPORAL_COHERENCE_ZSTD_LIBRARY AND
    TEMPORAL_COHERENCE_ZSTD_INCLUDE_DIR)
  set(TEMPORAL_COHERENCE_HAS_ZARR ON)
  list(APPEND volume_format_files
    ChunkCodec ContainedFolder JsonFiles ZarrChunk ZarrFillValue ZarrImage ZarrLevel
    ZarrMetadata ZarrMetadata3 ZarrSearch ZarrVolume)
  list(APPEND volume_format_definitions TEMPORAL_COHERENCE_HAS_ZARR)
  list(APPEND volume_format_libraries nlohmann_json::nlohmann_json ZLIB::ZLIB
    "${TEMPORAL_COHERENCE_BLOSC_LIBRARY}" "${TEMPORAL_COHERENCE_ZSTD_LIBRARY}")
  list(APPEND volume_format_includes
    "${TEMPORAL_COHERENCE_BLOSC_INCLUDE_DIR}" "${TEMPORAL_COHERENCE_ZSTD_INCLUDE_DIR}")
else ()
  set(TEMPORAL_COHERENCE_HAS_ZARR OFF)
endif ()
if (HDF5_FOUND AND ZLIB_FOUND)
  set(TEMPORAL_COHERENCE_HAS_HDF5 ON)
  list(APPEND volume_format_files
    Hdf5Attributes Hdf5BigDataViewer Hdf5Chunk Hdf5DataSet Hdf5DataSetRead Hdf5Imaris Hdf5Library
    Hdf5Plain Hdf5Types Hdf5Volume)
  list(APPEND volume_format_definitions TEMPORAL_COHERENCE_HAS_HDF5)
  list(APPEND volume_format_libraries ${HDF5_C_LIBRARIES} ZLIB::ZLIB)
  list(APPEND volume_format_includes ${HDF5_C_INCLUDE_DIRS})
else ()
  set(TEMPORAL_COHERENCE_HAS_HDF5 OFF)
endif ()
list(REMOVE_DUPLICATES volume_format_libraries)
list(TRANSFORM volume_format_files PREPEND "${CMAKE_CURRENT_LIST_DIR}/Vtk/VolumeFiles/")
list(TRANSFORM volume_format_files APPEND ".cxx")
