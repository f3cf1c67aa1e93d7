# The parts of MakeVolume, for the program itself and for tests.
include("${CMAKE_CURRENT_LIST_DIR}/../../../vtkTemporalCoherence/VolumeFormats.cmake")

set(volume_writer_files
  Benchmarks/Volumes/Chunks
  Benchmarks/Volumes/MixingLayer
  Benchmarks/Volumes/RawWriter
  Benchmarks/Volumes/Slabs
  Benchmarks/Volumes/TiffWriter
  Benchmarks/Volumes/WaveField)
set(volume_writer_readers) # files of the module that writers need
if (TEMPORAL_COHERENCE_HAS_ZARR)
  list(APPEND volume_writer_files Benchmarks/Volumes/OmeZarrWriter Common/VolumeFiles/ZarrWriter)
  list(APPEND volume_writer_readers ChunkCodec SampleBytes)
endif ()
if (TEMPORAL_COHERENCE_HAS_HDF5)
  list(APPEND volume_writer_files Benchmarks/Volumes/ImarisWriter Common/VolumeFiles/Hdf5Writer)
endif ()
list(TRANSFORM volume_writer_files PREPEND "${CMAKE_CURRENT_LIST_DIR}/../../")
list(TRANSFORM volume_writer_files APPEND ".cxx")
list(TRANSFORM volume_writer_readers PREPEND
  "${CMAKE_CURRENT_LIST_DIR}/../../../vtkTemporalCoherence/Vtk/VolumeFiles/")
list(TRANSFORM volume_writer_readers APPEND ".cxx")

# What a program of these files, or of readers, needs.
function (temporal_coherence_use_volume_files program)
  find_package(glm REQUIRED)
  find_package(Threads REQUIRED)
  set(testing "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../..")
  target_compile_features("${program}" PRIVATE cxx_std_17)
  target_compile_definitions("${program}" PRIVATE ${volume_format_definitions})
  target_include_directories("${program}" PRIVATE
    "${testing}/Benchmarks/Volumes"
    "${testing}/Common"
    "${testing}/../vtkTemporalCoherence"
    "${testing}/../vtkTemporalCoherence/Engine"
    "${testing}/../vtkTemporalCoherence/Vtk")
  target_include_directories("${program}" SYSTEM PRIVATE ${volume_format_includes})
  # CommonCore for the folder of vtk_tiff.h.
  target_link_libraries("${program}" PRIVATE
    ${volume_format_libraries} VTK::tiff VTK::CommonCore glm::glm Threads::Threads)
  if (PROJECT_NAME STREQUAL "vtkTemporalCoherence")
    target_compile_options("${program}" PRIVATE
      $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall;-Wextra;-Wconversion>
      $<$<AND:$<CXX_COMPILER_ID:GNU,Clang,AppleClang>,$<BOOL:${TEMPORAL_COHERENCE_WARNINGS_AS_ERRORS}>>:-Werror>)
  endif ()
endfunction ()
