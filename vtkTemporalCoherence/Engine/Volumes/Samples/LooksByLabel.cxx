// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Samples/LooksByLabel.h"

namespace TemporalCoherence
{

LooksByLabel::LooksByLabel(const Blending& volume)
{
  this->Looks.emplace_back(volume);
  for (std::size_t i = 0; volume.Labels && i < volume.Labels->Looks.size(); ++i)
  {
    this->Looks.emplace_back(volume, volume.Labels->Looks[i].Look);
  }
}

}
