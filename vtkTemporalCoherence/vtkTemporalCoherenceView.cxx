// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalCoherenceView.h"

#include "Output/ImageFromFrame.h"
#include "Scene/Frame.h"
#include "ViewFile/ViewFile.h"
#include "ViewFile/ViewLookUp.h"
#include "ViewFile/ViewPage.h"
#include "ViewFile/WholeFile.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"

#include <new>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTemporalCoherenceView);

/// The views that were read.
struct vtkTemporalCoherenceView::Internals
{
  TemporalCoherence::LoadedViews Views;
  TemporalCoherence::Frame Frame; ///< of the last look-up

  /// A view, or null.
  const TemporalCoherence::ViewEntry* At(int view) const
  {
    const auto& all = this->Views.Header.Views;
    const bool isThere = view >= 0 && static_cast<std::size_t>(view) < all.size();
    return isThere ? &all[static_cast<std::size_t>(view)] : nullptr;
  }

  const TemporalCoherence::ViewTexts& Texts() const { return this->Views.Header.Description.Texts; }
};

//------------------------------------------------------------------------------
vtkTemporalCoherenceView::vtkTemporalCoherenceView()
  : Internal(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkTemporalCoherenceView::~vtkTemporalCoherenceView() = default;

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceView::Read(const char* path)
{
  std::string wrong;
  try
  {
    std::vector<std::uint8_t> bytes;
    TemporalCoherence::LoadedViews views;
    wrong = TemporalCoherence::ReadWholeFile(path ? path : "", bytes);
    if (wrong.empty() && TemporalCoherence::IsPage(bytes))
    {
      std::vector<std::uint8_t> file;
      wrong = TemporalCoherence::FileInPage(bytes, file);
      bytes = std::move(file);
    }
    wrong = wrong.empty() ? TemporalCoherence::ReadViews(bytes, views) : wrong;
    if (wrong.empty())
    {
      this->Internal->Views = std::move(views);
      this->Modified();
      return true;
    }
  }
  catch (const std::bad_alloc&)
  {
    wrong = "There is not enough memory for the views.";
  }
  vtkErrorMacro("Cannot read " << (path ? path : "(null)") << ". " << wrong);
  return false;
}

//------------------------------------------------------------------------------
int vtkTemporalCoherenceView::GetNumberOfViews() const
{
  return static_cast<int>(this->Internal->Views.Header.Views.size());
}

//------------------------------------------------------------------------------
const char* vtkTemporalCoherenceView::GetTitle() const
{
  return this->Internal->Texts().Title.c_str();
}

//------------------------------------------------------------------------------
const char* vtkTemporalCoherenceView::GetCaption() const
{
  return this->Internal->Texts().Caption.c_str();
}

//------------------------------------------------------------------------------
const char* vtkTemporalCoherenceView::GetCitation() const
{
  return this->Internal->Texts().Citation.c_str();
}

//------------------------------------------------------------------------------
const char* vtkTemporalCoherenceView::GetUnits() const
{
  return this->Internal->Texts().Units.c_str();
}

//------------------------------------------------------------------------------
const char* vtkTemporalCoherenceView::GetHeader() const
{
  return this->Internal->Views.HeaderText.c_str();
}

//------------------------------------------------------------------------------
const char* vtkTemporalCoherenceView::GetViewName(int view) const
{
  const TemporalCoherence::ViewEntry* const entry = this->Internal->At(view);
  return entry ? entry->Geometry.Name.c_str() : "";
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceView::GetRange(int view, double range[2]) const
{
  const TemporalCoherence::ViewEntry* const entry = this->Internal->At(view);
  range[0] = entry ? entry->Range.Low : 1.0;
  range[1] = entry ? entry->Range.High : 0.0;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceView::GetSize(int view, int size[2]) const
{
  const TemporalCoherence::ViewEntry* const entry = this->Internal->At(view);
  size[0] = entry ? entry->Geometry.Rays.Size.x : 0;
  size[1] = entry ? entry->Geometry.Rays.Size.y : 0;
}

//------------------------------------------------------------------------------
double vtkTemporalCoherenceView::GetTolerance(int view) const
{
  const TemporalCoherence::ViewEntry* const entry = this->Internal->At(view);
  return entry ? entry->Geometry.Tolerance : 0.0;
}

//------------------------------------------------------------------------------
vtkIdType vtkTemporalCoherenceView::GetNumberOfKnots(int view) const
{
  const TemporalCoherence::ViewEntry* const entry = this->Internal->At(view);
  return entry ? static_cast<vtkIdType>(entry->Knots[0] + entry->Knots[1]) : 0;
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceView::LookUp(int view, double isovalue, vtkImageData* image)
{
  const TemporalCoherence::ViewEntry* const entry = this->Internal->At(view);
  if (!entry || !image)
  {
    vtkErrorMacro("LookUp needs an image, and a view from 0 to "
      << this->GetNumberOfViews() - 1 << "; it was given view " << view << ".");
    return false;
  }
  if (!entry->Range.Holds(isovalue))
  {
    vtkErrorMacro("The view holds isovalues from "
      << entry->Range.Low << " to " << entry->Range.High << ", not " << isovalue << ".");
    return false;
  }
  try
  {
    TemporalCoherence::LookUpView(entry->Geometry,
      this->Internal->Views.Knots[static_cast<std::size_t>(view)], isovalue, this->Internal->Frame);
    constexpr int arrays = TemporalCoherence::DepthArray | TemporalCoherence::NormalsArray |
      TemporalCoherence::IsovalueIndexArray | TemporalCoherence::AnswerArray;
    TemporalCoherence::WriteImages(this->Internal->Frame, { 0 }, { { image, arrays } });
    return true;
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro("There is not enough memory for an image of the view.");
    return false;
  }
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Title: " << this->GetTitle() << '\n';
  os << indent << "NumberOfViews: " << this->GetNumberOfViews() << '\n';
}
VTK_ABI_NAMESPACE_END
