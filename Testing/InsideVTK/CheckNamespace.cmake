# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Classes of VTK are declared in the namespace of its binary interface.
#
# Where VTK's binary interface has a namespace, a class of VTK declared outside of it is another class, and
# what uses it does not compile. Most builds of VTK have none and say nothing: here each declaration in
# a header of the module or of its tests is compared with it.
#
# cmake -D SOURCE=<the tree> -P CheckNamespace.cmake
cmake_minimum_required(VERSION 3.16)

file(GLOB_RECURSE headers "${SOURCE}/vtkTemporalCoherence/*.h" "${SOURCE}/Testing/Common/*.h"
  "${SOURCE}/Testing/Cxx/*.h" "${SOURCE}/Testing/Engine/*.h")
set(wrong "")
set(found 0)
foreach (header IN LISTS headers)
  file(READ "${header}" text)
  string(REPLACE ";" "@" text "${text}")
  string(REGEX MATCHALL "\nVTK_ABI_NAMESPACE_(BEGIN|END)|\n(class|struct) vtk[A-Za-z0-9]+@|\nclass VTK[A-Z]+_EXPORT [^\n]*"
    marks "${text}")
  set(inside NO)
  foreach (mark IN LISTS marks)
    string(STRIP "${mark}" mark)
    if (mark STREQUAL "VTK_ABI_NAMESPACE_BEGIN")
      set(inside YES)
    elseif (mark STREQUAL "VTK_ABI_NAMESPACE_END")
      set(inside NO)
    else ()
      math(EXPR found "${found} + 1")
      if (NOT inside)
        string(REPLACE "@" ";" mark "${mark}")
        string(APPEND wrong "\n  ${header}: ${mark}")
      endif ()
    endif ()
  endforeach ()
  if (inside)
    string(APPEND wrong "\n  ${header}: VTK_ABI_NAMESPACE_END is missing")
  endif ()
endforeach ()

if (found EQUAL 0)
  message(FATAL_ERROR "There is no header that declares a class of VTK below ${SOURCE}")
elseif (wrong)
  message(FATAL_ERROR
    "Put these between VTK_ABI_NAMESPACE_BEGIN and VTK_ABI_NAMESPACE_END (vtkTemporalCoherenceCompatibility.h):${wrong}")
endif ()
message(STATUS "${found} declarations are in the namespace")
