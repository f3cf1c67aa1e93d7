# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Read by CPack before it makes packages. Directories below the prefix, such as that of the library,
# are chosen for the prefix of the build, and are other ones for other prefixes.
if (CPACK_GENERATOR STREQUAL "DEB" AND
  NOT CPACK_PACKAGING_INSTALL_PREFIX STREQUAL CPACK_TEMPORAL_COHERENCE_PREFIX)
  message(FATAL_ERROR
    "Packages for ${CPACK_PACKAGING_INSTALL_PREFIX} cannot be made of a build for "
    "${CPACK_TEMPORAL_COHERENCE_PREFIX}: use Module/package.sh, or configure a build with "
    "-DCMAKE_INSTALL_PREFIX=${CPACK_PACKAGING_INSTALL_PREFIX}.")
endif ()
