// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// In place of OpenVkl.cxx where there is no Open VKL.

#include "OpenVkl.h"

std::vector<std::string> OpenVkl::Kinds()
{
  return {};
}

std::unique_ptr<OpenVkl> OpenVkl::Make(const Stage&, const std::string&)
{
  return nullptr;
}
