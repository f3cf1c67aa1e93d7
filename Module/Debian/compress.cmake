# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Run by CPack when all files of its packages lie ready: Debian's manual pages are compressed, without
# the time of day that gzip would put in.
file(GLOB_RECURSE manuals "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*/share/man/*.1")
foreach (manual IN LISTS manuals)
  execute_process(COMMAND gzip --force --best --no-name "${manual}" RESULT_VARIABLE result)
  if (result)
    message(FATAL_ERROR "${manual} could not be compressed")
  endif ()
endforeach ()
