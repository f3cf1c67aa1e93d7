// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewFile/ViewFile.h"

// A build without the libraries that files of views need.

namespace TemporalCoherence
{

std::string ViewFileMaker::WhyNot()
{
  return "This build was made without zlib or nlohmann-json, which view files need.";
}

void ViewFileMaker::Add(const ViewGeometry&, const KnotImage&) {}

std::vector<std::uint8_t> ViewFileMaker::Finish(const ViewDescription&)
{
  return {};
}

std::string ReadViews(const std::vector<std::uint8_t>&, LoadedViews&)
{
  return ViewFileMaker::WhyNot();
}

}
