// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What newer versions of VTK ask of every header, and older ones do not know: the namespace of the
 * binary interface (since 9.3), around whatever VTK declares or we do in its name, and hints for
 * what is generated from headers to store objects and to send them (since 9.4). In versions
 * without them they are nothing.
 */

#ifndef vtkTemporalCoherenceCompatibility_h
#define vtkTemporalCoherenceCompatibility_h

#include "vtkCommonCoreModule.h" // For the namespace, where there is one
#include "vtkWrappingHints.h"    // For hints, where there are any

#ifndef VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_BEGIN
#define VTK_ABI_NAMESPACE_END
#endif

#ifndef VTK_MARSHALAUTO
#define VTK_MARSHALAUTO
#define VTK_MARSHALEXCLUDE(reason)
#endif

#endif
// VTK-HeaderTest-Exclude: vtkTemporalCoherenceCompatibility.h
