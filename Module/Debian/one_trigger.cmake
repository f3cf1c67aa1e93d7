# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Run by CPack behind its packages. It gives each one with a library scripts that call ldconfig, which
# a trigger does already, as Debian's policy wants it: the scripts are taken out.
foreach (package IN LISTS CPACK_PACKAGE_FILES)
  execute_process(COMMAND dpkg-deb --ctrl-tarfile "${package}"
    COMMAND tar --to-stdout --extract --file - ./postinst
    OUTPUT_VARIABLE script ERROR_QUIET)
  if (NOT script MATCHES "ldconfig")
    continue ()
  endif ()
  set(unpacked "${package}.unpacked")
  file(REMOVE_RECURSE "${unpacked}")
  execute_process(COMMAND dpkg-deb --raw-extract "${package}" "${unpacked}" RESULT_VARIABLE result)
  file(REMOVE "${unpacked}/DEBIAN/postinst" "${unpacked}/DEBIAN/postrm")
  if (NOT result)
    execute_process(
      COMMAND dpkg-deb --root-owner-group "-Z${CPACK_DEBIAN_COMPRESSION_TYPE}" --build
        "${unpacked}" "${package}"
      RESULT_VARIABLE result OUTPUT_QUIET)
  endif ()
  file(REMOVE_RECURSE "${unpacked}")
  if (result)
    message(FATAL_ERROR "${package} could not be packed anew")
  endif ()
endforeach ()
