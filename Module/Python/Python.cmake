# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The Python package vtkTemporalCoherence: the wrapped classes and some pure Python. It is made in
# python/ of the build directory, and installed where VTK's Python looks below the prefix.

# Functions, as finding VTK a second time must not change what the build knows of it.
function (find_python_of_vtk)
  set(why)
  set(vtk_modules "${VTK_PREFIX_PATH}/${VTK_PYTHONPATH}")
  if (NOT BUILD_SHARED_LIBS)
    set(why "VTK's libraries are static")
  elseif (NOT VTK_WRAP_PYTHON)
    set(why "VTK was built without Python")
  else ()
    find_package(VTK QUIET COMPONENTS Python WrappingPythonCore)
    if (NOT VTK_FOUND OR NOT Python3_FOUND)
      set(why "there are no development files of Python (Debian: libpython3-dev)")
    else ()
      execute_process(
        COMMAND "${CMAKE_COMMAND}" -E env "PYTHONPATH=${vtk_modules}"
          "${Python3_EXECUTABLE}" -c "import vtkmodules.vtkRenderingVolume"
        RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
      if (NOT result EQUAL 0)
        set(why "${Python3_EXECUTABLE} has no vtkmodules (Debian: python3-vtk9)")
      endif ()
    endif ()
  endif ()
  set(why_no_python "${why}" PARENT_SCOPE)
  set(vtk_python "${Python3_EXECUTABLE}" PARENT_SCOPE)
  set(vtk_python_abi "${Python3_SOABI}" PARENT_SCOPE)
  set(vtk_python_modules "${vtk_modules}" PARENT_SCOPE)
endfunction ()

# Where that Python looks below the prefix, relative to it.
function (find_python_directory result)
  set(script [[
import site, sys
below = sys.argv[1].rstrip("/") + "/"
known = [path for path in site.getsitepackages() if path.startswith(below + "lib")]
other = "{}lib/python{}.{}/site-packages".format(below, *sys.version_info)
print((known + [other])[0][len(below):])
]])
  execute_process(
    COMMAND "${vtk_python}" -c "${script}" "${CMAKE_INSTALL_PREFIX}"
    OUTPUT_VARIABLE directory OUTPUT_STRIP_TRAILING_WHITESPACE)
  set("${result}" "${directory}" PARENT_SCOPE)
endfunction ()

find_python_of_vtk()
if (why_no_python AND NOT DEFINED CACHE{TEMPORAL_COHERENCE_WRAP_PYTHON})
  # Not kept: once what is missing is there, the next configuration finds it.
  message(STATUS "The Python package is left out: ${why_no_python}")
  set(TEMPORAL_COHERENCE_WRAP_PYTHON OFF)
  if (BUILD_TESTING)
    include("${CMAKE_SOURCE_DIR}/Testing/SkippedTest.cmake")
    temporal_coherence_skip_test(Python-Tests "the Python package is left out: ${why_no_python}")
  endif ()
else ()
  option(TEMPORAL_COHERENCE_WRAP_PYTHON "Build the Python package" ON)
endif ()
if (NOT TEMPORAL_COHERENCE_WRAP_PYTHON)
  return ()
endif ()
if (why_no_python)
  message(FATAL_ERROR
    "The Python package cannot be built, as ${why_no_python}: install what is missing or give "
    "-DTEMPORAL_COHERENCE_WRAP_PYTHON=OFF.")
endif ()

# A wheel. pip brings the version of VTK that pyproject.toml names. Highway is no Python package: a
# library of it lies beside ours.
if (DEFINED SKBUILD)
  file(STRINGS "${CMAKE_SOURCE_DIR}/pyproject.toml" dependencies REGEX "^dependencies = ")
  set(own_vtk "vtk == ${VTK_VERSION}")
  string(FIND "${dependencies}" "\"${own_vtk}\"" position)
  if (position EQUAL -1)
    message(FATAL_ERROR
      "The VTK that was found is ${VTK_VERSION}, and pyproject.toml says ${dependencies}: write "
      "${own_vtk} there, and the same version for vtk-sdk.")
  endif ()
  find_package(hwy REQUIRED)
  get_target_property(highway_type hwy::hwy TYPE)
  if (highway_type STREQUAL "SHARED_LIBRARY")
    install(FILES "$<TARGET_FILE:hwy::hwy>"
      RENAME "$<TARGET_SONAME_FILE_NAME:hwy::hwy>"
      DESTINATION "${CMAKE_INSTALL_LIBDIR}"
      COMPONENT runtime)
  endif ()
endif ()

find_python_directory(default_python_directory)
set(TEMPORAL_COHERENCE_PYTHON_DIRECTORY "${default_python_directory}"
  CACHE STRING "Where the Python package is installed, relative to the prefix")
if (IS_ABSOLUTE "${TEMPORAL_COHERENCE_PYTHON_DIRECTORY}")
  message(FATAL_ERROR
    "TEMPORAL_COHERENCE_PYTHON_DIRECTORY is ${TEMPORAL_COHERENCE_PYTHON_DIRECTORY}: give it relative "
    "to the prefix, as ${default_python_directory}.")
endif ()

vtk_module_wrap_python(
  MODULES VTK::TemporalCoherence
  TARGET vtkTemporalCoherence::Python
  PYTHON_PACKAGE vtkTemporalCoherence
  MODULE_DESTINATION "${TEMPORAL_COHERENCE_PYTHON_DIRECTORY}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  INSTALL_HEADERS OFF
  BUILD_STATIC OFF
  SOABI "${vtk_python_abi}"
  COMPONENT python)

# What is imported from the build directory does not lie as deep there as in an installation.
set(python_build_directory "${CMAKE_BINARY_DIR}/python")
set_target_properties(vtkTemporalCoherencePython PROPERTIES
  LIBRARY_OUTPUT_DIRECTORY "${python_build_directory}/vtkTemporalCoherence")

foreach (file IN ITEMS __init__.py blended.py everywhere.py given_data.py isosurfaces.py large_volumes.py
    mapper_support.py numpy_support.py pictures.py saved_views.py segmentations.py py.typed)
  configure_file("${CMAKE_CURRENT_LIST_DIR}/vtkTemporalCoherence/${file}"
    "${python_build_directory}/vtkTemporalCoherence/${file}" COPYONLY)
  install(
    FILES "${CMAKE_CURRENT_LIST_DIR}/vtkTemporalCoherence/${file}"
    DESTINATION "${TEMPORAL_COHERENCE_PYTHON_DIRECTORY}/vtkTemporalCoherence"
    COMPONENT python)
endforeach ()

# The pages for who writes Python, which docstrings name. Links between these lead somewhere.
foreach (page IN ITEMS Mapper.md Porting.md PyVista.md Python.md Sharing.md ViewFile.md)
  configure_file("${CMAKE_SOURCE_DIR}/Documentation/${page}"
    "${python_build_directory}/vtkTemporalCoherence/Documentation/${page}" COPYONLY)
  install(
    FILES "${CMAKE_SOURCE_DIR}/Documentation/${page}"
    DESTINATION "${TEMPORAL_COHERENCE_PYTHON_DIRECTORY}/vtkTemporalCoherence/Documentation"
    COMPONENT python)
endforeach ()

set(python_version "${python_build_directory}/vtkTemporalCoherence/version.py")
file(WRITE "${python_version}" "__version__ = \"${PROJECT_VERSION}\"\n")
install(
  FILES "${python_version}"
  DESTINATION "${TEMPORAL_COHERENCE_PYTHON_DIRECTORY}/vtkTemporalCoherence"
  COMPONENT python)

# What importlib.metadata and pip know of it; wheels have their own.
if (NOT DEFINED SKBUILD)
  set(python_metadata "vtkTemporalCoherence-${PROJECT_VERSION}.dist-info")
  file(WRITE "${python_build_directory}/${python_metadata}/METADATA"
    "Metadata-Version: 2.1\nName: vtkTemporalCoherence\nVersion: ${PROJECT_VERSION}\n"
    "Summary: Isosurfaces of volumes in VTK, ray cast on the CPU\nLicense: BSD-3-Clause\n")
  install(
    DIRECTORY "${python_build_directory}/${python_metadata}"
    DESTINATION "${TEMPORAL_COHERENCE_PYTHON_DIRECTORY}"
    COMPONENT python)
endif ()

# Types of the wrapped classes, for editors and checkers, by VTK's own generator. Debian has it since
# VTK 9.3.
execute_process(
  COMMAND "${CMAKE_COMMAND}" -E env "PYTHONPATH=${vtk_python_modules}"
    "${vtk_python}" -c "import vtkmodules.generate_pyi"
  RESULT_VARIABLE no_generator OUTPUT_QUIET ERROR_QUIET)
if (NOT no_generator)
  set(python_stub "${python_build_directory}/vtkTemporalCoherence/vtkTemporalCoherence.pyi")
  add_custom_command(OUTPUT "${python_stub}"
    COMMAND "${CMAKE_COMMAND}" -E env
      "PYTHONPATH=${python_build_directory}:${vtk_python_modules}"
      ${TEMPORAL_COHERENCE_PYTHON_ENVIRONMENT}
      "${vtk_python}" -m vtkmodules.generate_pyi --package vtkTemporalCoherence
      --output "${python_build_directory}/vtkTemporalCoherence" vtkTemporalCoherence
    DEPENDS vtkTemporalCoherencePython
    COMMENT "Writing types of the Python package"
    VERBATIM)
  add_custom_target(vtkTemporalCoherencePythonTypes ALL DEPENDS "${python_stub}")
  install(FILES "${python_stub}"
    DESTINATION "${TEMPORAL_COHERENCE_PYTHON_DIRECTORY}/vtkTemporalCoherence"
    COMPONENT python)
endif ()

if (BUILD_TESTING)
  add_subdirectory("${CMAKE_SOURCE_DIR}/Testing/Python" Testing/Python)
  add_subdirectory("${CMAKE_SOURCE_DIR}/Testing/PyVista" Testing/PyVista)
  add_subdirectory("${CMAKE_SOURCE_DIR}/Testing/ViewPage" Testing/ViewPage)
endif ()
