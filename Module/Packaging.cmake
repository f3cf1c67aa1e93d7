# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Debian packages of a build, by `cpack` or the target `package`; Module/package.sh does all that is
# needed from nothing. The packages are the library, what others build against it with, the Python
# package, pages and examples, and, where they are built, the command and the Explorer. Included last,
# when all that is installed is known.

find_program(TEMPORAL_COHERENCE_DPKG dpkg)
mark_as_advanced(TEMPORAL_COHERENCE_DPKG)
if (NOT TEMPORAL_COHERENCE_DPKG OR NOT BUILD_SHARED_LIBS)
  message(STATUS "No Debian packages: there is no dpkg, or VTK's libraries are static")
  return ()
endif ()

set(TEMPORAL_COHERENCE_DEBIAN_REVISION 1 CACHE STRING
  "What follows the version of the project in that of a Debian package")
set(default_maintainer "the vtkTemporalCoherence authors <vtktemporalcoherence@example.org>")
if (DEFINED ENV{DEBEMAIL} AND DEFINED ENV{DEBFULLNAME})
  set(default_maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif ()
set(TEMPORAL_COHERENCE_DEBIAN_MAINTAINER "${default_maintainer}" CACHE STRING
  "Who answers for the Debian packages: name and address; default: DEBFULLNAME <DEBEMAIL>")

# Messages name source files; those of a package must not name the directory of who built it.
foreach (part IN ITEMS
    TemporalCoherenceEngine TemporalCoherenceVolumes TemporalCoherence vtkTemporalCoherenceAutoload
    vtkTemporalCoherencePython ${program_targets})
  if (TARGET "${part}")
    target_compile_options("${part}" PRIVATE
      $<$<CXX_COMPILER_ID:GNU,Clang>:-fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=>)
  endif ()
  # Below /usr the system finds libraries; in other prefixes they find each other by where they lie.
  if (TARGET "${part}" AND CMAKE_INSTALL_PREFIX STREQUAL "/usr")
    set_target_properties("${part}" PROPERTIES INSTALL_RPATH "")
  endif ()
endforeach ()

set(CPACK_GENERATOR DEB)
set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_IGNORE_FILES "/\\\\.git/;${CMAKE_SOURCE_DIR}/build[^/]*/;${CMAKE_SOURCE_DIR}/install/")
set(CPACK_OUTPUT_FILE_PREFIX "${CMAKE_BINARY_DIR}/packages")
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_PROJECT_CONFIG_FILE "${CMAKE_SOURCE_DIR}/Module/Debian/cpack.cmake")
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_SOURCE_DIR}/Module/Debian/compress.cmake")
set(CPACK_TEMPORAL_COHERENCE_PREFIX "${CMAKE_INSTALL_PREFIX}")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SOURCE vtktemporalcoherence)
set(CPACK_DEBIAN_PACKAGE_RELEASE "${TEMPORAL_COHERENCE_DEBIAN_REVISION}")
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${TEMPORAL_COHERENCE_DEBIAN_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")

set(debian_version "${PROJECT_VERSION}-${TEMPORAL_COHERENCE_DEBIAN_REVISION}")
set(debian_directory "${CMAKE_BINARY_DIR}/Module/Debian")
set(debian_library "libvtktemporalcoherence${PROJECT_VERSION_MAJOR}")

# Programs of another minor version are not promised to work; see the CMake package's version file.
math(EXPR debian_next_minor "${PROJECT_VERSION_MINOR} + 1")
set(debian_next_minor "${PROJECT_VERSION_MAJOR}.${debian_next_minor}")
configure_file("${CMAKE_SOURCE_DIR}/Module/Debian/shlibs.in" "${debian_directory}/shlibs" @ONLY)

# The versions of a package of VTK that are the version this was built with.
function (vtk_dependency package result)
  set(minor "${VTK_MAJOR_VERSION}.${VTK_MINOR_VERSION}")
  math(EXPR next "${VTK_MINOR_VERSION} + 1")
  set("${result}" "${package} (>= ${minor}~), ${package} (<< ${VTK_MAJOR_VERSION}.${next}~)" PARENT_SCOPE)
endfunction ()
vtk_dependency("libvtk${VTK_MAJOR_VERSION}-dev" debian_vtk_development)
vtk_dependency("python3-vtk${VTK_MAJOR_VERSION}" debian_vtk_python)

# Debian's documents, compressed and without the time of day that gzip would put in.
string(TIMESTAMP debian_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file("${CMAKE_SOURCE_DIR}/Module/Debian/changelog.in" "${debian_directory}/changelog.Debian" @ONLY)
configure_file("${CMAKE_SOURCE_DIR}/CHANGELOG.md" "${debian_directory}/changelog" COPYONLY)
execute_process(COMMAND gzip --force --keep --best --no-name changelog changelog.Debian
  WORKING_DIRECTORY "${debian_directory}")

# A package is a group of two components: what is installed anyway, and documents that only
# packages have.
macro (debian_package group component name)
  cpack_add_component_group("${group}")
  cpack_add_component("${component}" GROUP "${group}")
  cpack_add_component("${group}-documents" GROUP "${group}")
  list(APPEND CPACK_COMPONENTS_ALL "${component}" "${group}-documents")
  install(
    FILES "${debian_directory}/changelog.gz" "${debian_directory}/changelog.Debian.gz"
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/${name}"
    COMPONENT "${group}-documents" EXCLUDE_FROM_ALL)
  install(
    FILES "${CMAKE_SOURCE_DIR}/LICENSE" RENAME copyright
    DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/doc/${name}"
    COMPONENT "${group}-documents" EXCLUDE_FROM_ALL)
  string(TOUPPER "${group}" upper)
  set("CPACK_DEBIAN_${upper}_PACKAGE_NAME" "${name}")
endmacro ()

include(CPackComponent)
set(CPACK_COMPONENTS_ALL)
set(debian_description
"Isosurfaces of images and of any grid of VTK, ray-cast on the CPU, exact at
every pixel, with ambient occlusion, shadows and smooth edges; composite
volumes and projections of images. Needs no GPU, no OpenGL and no display. In
a still view, new colours and isovalues use what the last frame has found.
Takes the place of the mapper of a vtkVolume.

")

debian_package(library runtime "${debian_library}")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA
  "${debian_directory}/shlibs" "${CMAKE_SOURCE_DIR}/Module/Debian/triggers")
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION
"isosurfaces and volumes for VTK by rays on the CPU - library
${debian_description}This package holds the library.")

debian_package(headers development libvtktemporalcoherence-dev)
set(CPACK_DEBIAN_HEADERS_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_HEADERS_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_HEADERS_PACKAGE_DEPENDS "${debian_library} (= ${debian_version}), ${debian_vtk_development}")
set(CPACK_DEBIAN_HEADERS_DESCRIPTION
"isosurfaces and volumes for VTK by rays on the CPU - development files
${debian_description}This package holds the headers and the CMake package vtkTemporalCoherence.")

# Pages and examples keep their places beside each other, as they name each other.
set(debian_pages "${CMAKE_INSTALL_DATAROOTDIR}/doc/vtktemporalcoherence-doc")
install(DIRECTORY "${CMAKE_SOURCE_DIR}/Documentation" "${CMAKE_SOURCE_DIR}/Examples"
  DESTINATION "${debian_pages}"
  COMPONENT documentation EXCLUDE_FROM_ALL
  PATTERN "*.sh" EXCLUDE
  PATTERN "film.py" EXCLUDE
  PATTERN "__pycache__" EXCLUDE)
install(FILES "${CMAKE_SOURCE_DIR}/README.md"
  DESTINATION "${debian_pages}"
  COMPONENT documentation EXCLUDE_FROM_ALL)
debian_package(pages documentation vtktemporalcoherence-doc)
set(CPACK_DEBIAN_PAGES_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_PAGES_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PAGES_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_PAGES_DESCRIPTION
"isosurfaces and volumes for VTK by rays on the CPU - documentation
${debian_description}This package holds the pages, and examples in C++ and Python.")

get_cmake_property(debian_components COMPONENTS)
if ("command" IN_LIST debian_components)
  debian_package(program command vtktemporalcoherence-bin)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${debian_library} (= ${debian_version})")
  set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
"pictures and films of volumes, by one command without a window
The command temporal-coherence draws the volume of a file (VTK, NIfTI,
MetaImage, DICOM, Exodus, raw samples and others) into a picture or a film:
isosurfaces, see-through volumes with presets for CT and MR, or projections.
Rays are cast on the CPU. It needs no GPU, no OpenGL and no display.")
endif ()
if ("explorer" IN_LIST debian_components)
  debian_package(viewer explorer vtktemporalcoherence-explorer)
  set(CPACK_DEBIAN_VIEWER_PACKAGE_SECTION science)
  set(CPACK_DEBIAN_VIEWER_PACKAGE_DEPENDS "${debian_library} (= ${debian_version})")
  set(CPACK_DEBIAN_VIEWER_DESCRIPTION
"viewer of isosurfaces and volumes that needs no GPU
A window with the volume of a file (VTK, NIfTI, MetaImage, DICOM, Exodus, raw
samples and others): turn it, drag isovalues in its histogram, cut it, choose
presets for CT and MR, measure distances, save pictures, films and triangles.
Rays are cast on the CPU, and pictures get better while nothing is done.")
endif ()
if ("python" IN_LIST debian_components)
  # An extension module works with the version of Python that it was built for.
  string(REGEX REPLACE "^cpython-3([0-9]+).*" "\\1" debian_python "${vtk_python_abi}")
  math(EXPR debian_next_python "${debian_python} + 1")
  debian_package(python3 python python3-vtktemporalcoherence)
  set(CPACK_DEBIAN_PYTHON3_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON3_PACKAGE_CONTROL_EXTRA
    "${CMAKE_SOURCE_DIR}/Module/Debian/postinst" "${CMAKE_SOURCE_DIR}/Module/Debian/prerm")
  string(CONCAT CPACK_DEBIAN_PYTHON3_PACKAGE_DEPENDS
    "${debian_library} (= ${debian_version}), ${debian_vtk_python}, python3-numpy, "
    "python3 (>= 3.${debian_python}~), python3 (<< 3.${debian_next_python}~)")
  set(CPACK_DEBIAN_PYTHON3_DESCRIPTION
"isosurfaces and volumes for VTK by rays on the CPU - Python 3
${debian_description}This package holds the Python package vtkTemporalCoherence.")
endif ()

include(CPack)
