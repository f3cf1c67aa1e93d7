// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Macros that newer versions of VTK expect in every header. Versions of VTK without them get empty
 * macros: VTK_ABI_NAMESPACE_BEGIN and VTK_ABI_NAMESPACE_END (since 9.3) enclose all declarations of
 * VTK classes; VTK_MARSHALAUTO and VTK_MARSHALEXCLUDE (since 9.4) are hints for the code that VTK
 * generates to serialize objects.
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
