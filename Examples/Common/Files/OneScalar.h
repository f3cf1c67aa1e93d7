// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OneScalar_h
#define OneScalar_h

#include "Files/Volume.h"

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

// A data set with one array of one component, at the points: what is drawn of it, for VTK's
// filters, which read beyond the ends of others. Null if the data set has none.
// \param component of the array; -1: the length of its vectors
vtkSmartPointer<vtkDataSet> WithOneScalar(
  vtkDataSet* set, const ArrayChoice& choice, int component = 0);

#endif
