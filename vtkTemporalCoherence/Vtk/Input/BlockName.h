// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BlockName_h
#define TemporalCoherence_BlockName_h

#include <vtkCompositeDataSet.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkInformation.h>

#include <string>

namespace TemporalCoherence
{

/// The name of an iterator's present block in messages.
inline std::string NameOfLeaf(vtkDataObjectTreeIterator* leaf)
{
  std::string name = "Block " + std::to_string(leaf->GetCurrentFlatIndex());
  vtkInformation* about = leaf->HasCurrentMetaData() ? leaf->GetCurrentMetaData() : nullptr;
  if (about && about->Has(vtkCompositeDataSet::NAME()))
  {
    name += std::string(" ('") + about->Get(vtkCompositeDataSet::NAME()) + "')";
  }
  return name;
}

}

#endif
