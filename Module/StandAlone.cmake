# The stand-alone build: find VTK, build the one module, install it as a CMake package, test it.

option(TEMPORAL_COHERENCE_BUILD_BENCHMARKS "Build the benchmark programs" ON)
option(TEMPORAL_COHERENCE_BUILD_PROGRAMS "Build and install the command and the Explorer" OFF)
option(TEMPORAL_COHERENCE_WARNINGS_AS_ERRORS "Treat compiler warnings in our files as errors" OFF)

if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif ()

include(GNUInstallDirs)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")

# The two descriptions of the module must be one.
file(SHA256 "${CMAKE_SOURCE_DIR}/vtk.module" root_description)
file(SHA256 "${CMAKE_SOURCE_DIR}/Module/vtkTemporalCoherence.module" own_description)
if (NOT root_description STREQUAL own_description)
  message(FATAL_ERROR
    "vtk.module and Module/vtkTemporalCoherence.module differ: copy the newer over the older.")
endif ()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
  "${CMAKE_SOURCE_DIR}/vtk.module" "${CMAKE_SOURCE_DIR}/Module/vtkTemporalCoherence.module")

include(CTest)

# Always by component: without components, VTK's package asks for Qt.
set(vtk_components
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonMisc CommonTransforms
  IOImage IOXML IOXMLParser RenderingCore RenderingOpenGL2 RenderingVolume RenderingVolumeOpenGL2)
if (BUILD_TESTING OR TEMPORAL_COHERENCE_BUILD_BENCHMARKS OR TEMPORAL_COHERENCE_BUILD_PROGRAMS)
  list(APPEND vtk_components
    CommonSystem FiltersAMR FiltersCore FiltersGeometry FiltersSources ImagingCore InteractionStyle IOGeometry IOLegacy
    IOPLY RenderingAnnotation RenderingFreeType RenderingImage TestingCore TestingRendering jsoncpp png tiff zlib)
endif ()
set(vtk_chart_components)
set(vtk_reader_components) # of meshes and HDF5, for examples, benchmarks and tests
if (BUILD_TESTING OR TEMPORAL_COHERENCE_BUILD_BENCHMARKS OR TEMPORAL_COHERENCE_BUILD_PROGRAMS)
  set(vtk_reader_components IOCGNSReader IOExodus IOHDF IOParallel)
endif ()
set(vtk_program_components)
if (TEMPORAL_COHERENCE_BUILD_PROGRAMS)
  # What these link is looked for here: targets that are found below are not seen here.
  set(vtk_program_components GUISupportQt InteractionWidgets IOOggTheora)
endif ()
if (TEMPORAL_COHERENCE_BUILD_BENCHMARKS)
  set(vtk_chart_components
    ChartsCore IOExport RenderingContext2D RenderingContextOpenGL2)
endif ()
find_package(VTK 9.1 REQUIRED
  COMPONENTS ${vtk_components}
  OPTIONAL_COMPONENTS ${vtk_chart_components} ${vtk_reader_components} ${vtk_program_components})

# Shared exactly when VTK is.
get_target_property(vtk_library_type VTK::CommonCore TYPE)
set(BUILD_SHARED_LIBS ON)
if (vtk_library_type STREQUAL "STATIC_LIBRARY")
  set(BUILD_SHARED_LIBS OFF)
endif ()

set(scan_tests OFF)
if (BUILD_TESTING)
  set(scan_tests ON)
endif ()
vtk_module_scan(
  MODULE_FILES "${CMAKE_SOURCE_DIR}/Module/vtkTemporalCoherence.module"
  REQUEST_MODULES VTK::TemporalCoherence
  PROVIDES_MODULES modules
  ENABLE_TESTS "${scan_tests}")
vtk_module_build(
  MODULES ${modules}
  PACKAGE vtkTemporalCoherence
  INSTALL_EXPORT vtkTemporalCoherence
  VERSION "${PROJECT_VERSION}"
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/vtkTemporalCoherence"
  CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/vtkTemporalCoherence"
  TEST_DIRECTORY_NAME "../Testing"
  TEST_INPUT_DATA_DIRECTORY "${CMAKE_SOURCE_DIR}/Testing/Data"
  TEST_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/Testing/Temporary")

# Set here, because vtk_module_build takes a SOVERSION of 0 for none.
vtk_module_set_properties(VTK::TemporalCoherence SOVERSION "${PROJECT_VERSION_MAJOR}")

include("${CMAKE_SOURCE_DIR}/Module/Autoload/Autoload.cmake")
include("${CMAKE_SOURCE_DIR}/Module/Python/Python.cmake")

if (TEMPORAL_COHERENCE_BUILD_BENCHMARKS)
  add_subdirectory(Testing/Benchmarks)
endif ()

include(CMakePackageConfigHelpers)
set(package_directory "${CMAKE_INSTALL_LIBDIR}/cmake/vtkTemporalCoherence")
# Beside the targets of the build, so that find_package works with a build directory, too.
set(package_build_directory "${CMAKE_BINARY_DIR}/${package_directory}")
configure_package_config_file(
  "${CMAKE_SOURCE_DIR}/Module/vtkTemporalCoherenceConfig.cmake.in"
  "${package_build_directory}/vtkTemporalCoherenceConfig.cmake"
  INSTALL_DESTINATION "${package_directory}")
write_basic_package_version_file(
  "${package_build_directory}/vtkTemporalCoherenceConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${package_build_directory}/vtkTemporalCoherenceConfig.cmake"
    "${package_build_directory}/vtkTemporalCoherenceConfigVersion.cmake"
  DESTINATION "${package_directory}"
  COMPONENT development)
install(FILES "${CMAKE_SOURCE_DIR}/LICENSE"
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/vtkTemporalCoherence"
  COMPONENT license)

include("${CMAKE_SOURCE_DIR}/Module/Programs.cmake")
include("${CMAKE_SOURCE_DIR}/Module/Packaging.cmake")
