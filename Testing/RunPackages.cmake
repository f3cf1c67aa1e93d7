# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The Debian packages of a build hold what they have to, name no directory of the build, and suffice to
# build a small program.
#
# Called by ctest (see Packages.cmake) with
#   BUILD SOURCE VERSION       the build, its sources and their version
#   PREFIX LIBRARY_DIRECTORY   what the build is to be installed in
#   SCRATCH                    the directory where all this happens
#   CONFIGURATION GENERATOR CXX_COMPILER C_COMPILER CXX_FLAGS VTK_DIR
cmake_minimum_required(VERSION 3.16)

find_program(dpkg_deb dpkg-deb)
find_program(dpkg_shlibdeps dpkg-shlibdeps)
find_program(file_program file)
if (NOT dpkg_deb OR NOT dpkg_shlibdeps OR NOT file_program OR NOT EXISTS "${BUILD}/CPackConfig.cmake")
  message("No packages can be made here: that takes Debian with its packages dpkg-dev and file.")
  return ()
endif ()

# Runs a command that has to succeed, and gives what it printed.
function (run output_name)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if (NOT result EQUAL 0)
    message(FATAL_ERROR "Failed (${result}): ${ARGN}\n${output}")
  endif ()
  set("${output_name}" "${output}" PARENT_SCOPE)
endfunction ()

function (expect_match what text expression)
  if (NOT text MATCHES "${expression}")
    message(FATAL_ERROR "${what}: expected '${expression}' in\n${text}")
  endif ()
endfunction ()

function (expect_no_match what text expression)
  if (text MATCHES "${expression}")
    message(FATAL_ERROR "${what}: did not expect '${expression}' in\n${text}")
  endif ()
endfunction ()

set(root "${SCRATCH}/root")
set(prefix "${root}${PREFIX}")
file(REMOVE_RECURSE "${SCRATCH}/made" "${SCRATCH}/unpacked" "${root}")
file(MAKE_DIRECTORY "${SCRATCH}/unpacked")

# A build for another prefix than /usr makes packages only if it is told to.
if (NOT PREFIX STREQUAL "/usr")
  execute_process(COMMAND "${CMAKE_CPACK_COMMAND}" -G DEB --config "${BUILD}/CPackConfig.cmake" -B "${SCRATCH}/made"
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
  expect_match("Packages for another prefix" "${output}"
    "Packages for /usr cannot be made of a build for ${PREFIX}: use Module/package.sh")
  if (result EQUAL 0)
    message(FATAL_ERROR "cpack succeeded for another prefix")
  endif ()
endif ()

run(output "${CMAKE_CPACK_COMMAND}" -G DEB -C "${CONFIGURATION}" --config "${BUILD}/CPackConfig.cmake"
  -B "${SCRATCH}/made" -D "CPACK_PACKAGING_INSTALL_PREFIX=${PREFIX}"
  -D "CPACK_OUTPUT_FILE_PREFIX=${SCRATCH}/made" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip)

# What a package has to hold, relative to the prefix; its documents are the same in all.
string(REGEX MATCH "^[0-9]+" major "${VERSION}")
set(library "libvtktemporalcoherence${major}")
set(cmake_directory "${LIBRARY_DIRECTORY}/cmake/vtkTemporalCoherence")
set("contents_of_${library}"
  "${LIBRARY_DIRECTORY}/libvtkTemporalCoherence.so.${VERSION}"
  "${LIBRARY_DIRECTORY}/libvtkTemporalCoherence.so.${major}"
  "${LIBRARY_DIRECTORY}/vtkTemporalCoherence/autoload/vtkTemporalCoherenceAutoload.so")
set(contents_of_libvtktemporalcoherence-dev
  "${LIBRARY_DIRECTORY}/libvtkTemporalCoherence.so"
  "${LIBRARY_DIRECTORY}/vtk/hierarchy/vtkTemporalCoherence/vtkTemporalCoherence-hierarchy.txt"
  "${cmake_directory}/vtkTemporalCoherence-targets.cmake"
  "${cmake_directory}/vtkTemporalCoherence-vtk-module-properties.cmake"
  "${cmake_directory}/vtkTemporalCoherenceConfig.cmake"
  "${cmake_directory}/vtkTemporalCoherenceConfigVersion.cmake"
  include/vtkTemporalCoherence/vtkTemporalCoherenceModule.h
  include/vtkTemporalCoherence/vtkTemporalCoherenceCompatibility.h
  include/vtkTemporalCoherence/vtkTemporalCoherenceBrickSource.h
  include/vtkTemporalCoherence/vtkTemporalCoherenceDropInMapper.h
  include/vtkTemporalCoherence/vtkTemporalCoherenceGPUVolumeRayCastMapper.h
  include/vtkTemporalCoherence/vtkTemporalCoherenceObjectFactory.h
  include/vtkTemporalCoherence/vtkTemporalCoherencePaperMapper.h
  include/vtkTemporalCoherence/vtkTemporalCoherencePicker.h
  include/vtkTemporalCoherence/vtkTemporalCoherencePresets.h
  include/vtkTemporalCoherence/vtkTemporalCoherenceRefiner.h
  include/vtkTemporalCoherence/vtkTemporalCoherenceStatistics.h
  include/vtkTemporalCoherence/vtkTemporalCoherenceView.h
  include/vtkTemporalCoherence/vtkTemporalCoherenceViewWriter.h
  include/vtkTemporalCoherence/vtkTemporalCoherenceVolume.h
  include/vtkTemporalCoherence/vtkTemporalCoherenceVolumeMapper.h)
set(packages "${library}" libvtktemporalcoherence-dev)

load_cache("${BUILD}" READ_WITH_PREFIX build_ CMAKE_BUILD_TYPE TEMPORAL_COHERENCE_PYTHON_DIRECTORY)
set(python_directory "${build_TEMPORAL_COHERENCE_PYTHON_DIRECTORY}")
file(GLOB extension_module RELATIVE "${BUILD}/python" "${BUILD}/python/vtkTemporalCoherence/*.so")
if (extension_module)
  # Modules, pages, py.typed, and, where VTK can make them, types of the wrapped classes.
  file(GLOB modules RELATIVE "${SOURCE}/Module/Python"
    "${SOURCE}/Module/Python/vtkTemporalCoherence/*.py"
    "${SOURCE}/Module/Python/vtkTemporalCoherence/py.typed")
  file(GLOB types RELATIVE "${BUILD}/python" "${BUILD}/python/vtkTemporalCoherence/*.pyi")
  list(APPEND modules ${types})
  file(GLOB metadata RELATIVE "${BUILD}/python" "${BUILD}/python/*.dist-info/METADATA")
  file(GLOB pages RELATIVE "${BUILD}/python" "${BUILD}/python/vtkTemporalCoherence/Documentation/*.md")
  list(APPEND modules vtkTemporalCoherence/version.py ${metadata} ${pages})
  list(TRANSFORM modules PREPEND "${python_directory}/")
  set(contents_of_python3-vtktemporalcoherence ${modules} "${python_directory}/${extension_module}")
  list(APPEND packages python3-vtktemporalcoherence)
endif ()

# Pages and examples, as they lie here.
file(GLOB_RECURSE pages RELATIVE "${SOURCE}" "${SOURCE}/Documentation/*" "${SOURCE}/Examples/*")
list(FILTER pages EXCLUDE REGEX "\\.sh$|film\\.py$|__pycache__")
list(TRANSFORM pages PREPEND share/doc/vtktemporalcoherence-doc/)
set(contents_of_vtktemporalcoherence-doc ${pages} share/doc/vtktemporalcoherence-doc/README.md)
list(APPEND packages vtktemporalcoherence-doc)

load_cache("${BUILD}" READ_WITH_PREFIX build_ TEMPORAL_COHERENCE_BUILD_PROGRAMS TEMPORAL_COHERENCE_QVTK)
if (build_TEMPORAL_COHERENCE_BUILD_PROGRAMS)
  set(contents_of_vtktemporalcoherence-bin
    bin/temporal-coherence share/man/man1/temporal-coherence.1.gz)
  list(APPEND packages vtktemporalcoherence-bin)
  if (build_TEMPORAL_COHERENCE_QVTK)
    set(explorer vtktemporalcoherence-explorer)
    set("contents_of_${explorer}"
      "bin/${explorer}"
      "share/applications/${explorer}.desktop"
      "share/icons/hicolor/scalable/apps/${explorer}.svg"
      "share/man/man1/${explorer}.1.gz"
      "share/mime/packages/${explorer}.xml")
    list(APPEND packages "${explorer}")
  endif ()
endif ()

string(TOLOWER "${CONFIGURATION}" configuration)
foreach (package IN LISTS packages)
  file(GLOB deb "${SCRATCH}/made/${package}_${VERSION}-*.deb")
  if (NOT deb)
    message(FATAL_ERROR "There is no package ${package}; cpack said\n${output}")
  endif ()
  set(unpacked "${SCRATCH}/unpacked/${package}")
  run(ignored "${dpkg_deb}" -x "${deb}" "${unpacked}")
  run(ignored "${dpkg_deb}" -x "${deb}" "${root}")
  run(control_of_${package} "${dpkg_deb}" -f "${deb}")

  set(expected ${contents_of_${package}})
  foreach (document IN ITEMS changelog.Debian.gz changelog.gz copyright)
    list(APPEND expected "share/doc/${package}/${document}")
  endforeach ()
  file(GLOB_RECURSE held RELATIVE "${unpacked}${PREFIX}" "${unpacked}/*")
  # Exported targets have a file of their own for every configuration.
  list(FILTER held EXCLUDE REGEX "vtkTemporalCoherence-targets-${configuration}\\.cmake$")
  list(SORT expected)
  list(SORT held)
  if (NOT held STREQUAL expected)
    string(REPLACE ";" "\n  " held "${held}")
    string(REPLACE ";" "\n  " expected "${expected}")
    message(FATAL_ERROR "${package} holds\n  ${held}\ninstead of\n  ${expected}")
  endif ()
endforeach ()
file(GLOB made "${SCRATCH}/made/*.deb")
list(LENGTH made made_count)
list(LENGTH packages count)
if (NOT made_count EQUAL count)
  message(FATAL_ERROR "Expected the packages ${packages}, got ${made}")
endif ()
message(STATUS "Packages hold what they have to: ${packages}")

expect_match("Library" "${control_of_${library}}" "Depends:[^\n]*libvtk9")
expect_match("Development" "${control_of_libvtktemporalcoherence-dev}"
  "Depends: ${library} \\(= ${VERSION}-[0-9]+\\), libvtk9-dev ")
expect_no_match("Development" "${control_of_libvtktemporalcoherence-dev}" "Depends:[^\n]*(glm|hwy)")
if (extension_module)
  expect_match("Python" "${control_of_python3-vtktemporalcoherence}"
    "Depends:[^\n]*${library} \\(= ${VERSION}-[0-9]+\\), python3-vtk9 [^\n]*, python3-numpy")
endif ()

# Libraries are found by the system or by where they lie beside each other, never in a fixed directory.
set(run_path "R(UN)?PATH[^[]*\\[[^$]")
if (PREFIX STREQUAL "/usr")
  set(run_path "R(UN)?PATH")
endif ()
find_program(readelf readelf REQUIRED)
set(shared_library "${prefix}/${LIBRARY_DIRECTORY}/libvtkTemporalCoherence.so.${VERSION}")
file(GLOB_RECURSE binaries "${prefix}/*.cpython-*.so" "${prefix}/*Autoload.so")
foreach (binary IN LISTS shared_library binaries)
  run(dynamic "${readelf}" -d "${binary}")
  expect_no_match("${binary}" "${dynamic}" "${run_path}")
  if (binary STREQUAL shared_library)
    expect_match("Library" "${dynamic}" "SONAME[^\n]*libvtkTemporalCoherence\\.so\\.${major}\\]")
  endif ()
endforeach ()
foreach (directory IN ITEMS "${BUILD}" "${SOURCE}")
  execute_process(COMMAND grep --recursive --files-with-matches --fixed-strings "${directory}/" "${root}"
    OUTPUT_VARIABLE found)
  if (found)
    message(FATAL_ERROR "The directory of the build is named in\n${found}")
  endif ()
endforeach ()
message(STATUS "The library has its SONAME; nothing names the directory of the build")

# Builds and runs a small program against what is found in a directory; how: a setting for find_package.
set(consumer_arguments -S "${SOURCE}/Testing/Packages/Consumer" -G "${GENERATOR}"
  "-DCMAKE_BUILD_TYPE=${CONFIGURATION}"
  "-DCMAKE_C_COMPILER=${C_COMPILER}"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
  "-DVTK_DIR=${VTK_DIR}")
function (build_consumer name where how)
  set(directory "${SCRATCH}/${name}")
  run(ignored "${CMAKE_COMMAND}" -B "${directory}" ${consumer_arguments}
    "-D${how}" "-DWANTED_VERSION=${VERSION}")
  file(STRINGS "${directory}/CMakeCache.txt" found REGEX "^vtkTemporalCoherence_DIR:")
  string(FIND "${found}" "=${where}/" position)
  if (position EQUAL -1)
    message(FATAL_ERROR "Consumer was not built against ${where} but: ${found}")
  endif ()
  run(ignored "${CMAKE_COMMAND}" --build "${directory}" --config "${CONFIGURATION}")
  find_program("program_${name}" Consumer
    PATHS "${directory}" PATH_SUFFIXES "${CONFIGURATION}" NO_DEFAULT_PATH REQUIRED)
  run(ignored "${program_${name}}")
endfunction ()

# Unpacked here, not in the prefix: what is installed can be moved.
build_consumer(Consumer "${prefix}" "CMAKE_PREFIX_PATH=${prefix}")
build_consumer(ConsumerOfBuild "${BUILD}" "vtkTemporalCoherence_DIR=${BUILD}/${cmake_directory}")
message(STATUS "A program is built against what is in the packages, and against the build")

execute_process(
  COMMAND "${CMAKE_COMMAND}" -B "${SCRATCH}/Consumer" ${consumer_arguments} -DWANTED_VERSION=99.1
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
expect_match("A consumer that wants version 99.1" "${output}" "requested version \"99\\.1\"")
expect_match("A consumer that wants version 99.1" "${output}" "version: ${VERSION}")
message(STATUS "A program that wants another version is told which there is")
