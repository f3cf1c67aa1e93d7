// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalIsosurfaceRepresentation.h"

#include "DistributedPart.h"
#include "MergedMesh.h"

#include "vtkColorTransferFunction.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkContourValues.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOutlineSource.h"
#include "vtkPVRenderView.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTemporalCoherenceRefiner.h"
#include "vtkTemporalCoherenceVolumeMapper.h"
#include "vtkTemporalIsosurfaceActor.h"
#include "vtkTemporalIsosurfaceLabelTable.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>

vtkStandardNewMacro(vtkTemporalIsosurfaceRepresentation);

namespace
{

constexpr vtkIdType NumberOfRoutes =
  vtkTemporalCoherenceVolumeMapper::ROUTE_KEEP_LABELS + 1; // the last one

bool IsAlone(vtkMultiProcessController* controller)
{
  return !controller || controller->GetNumberOfProcesses() < 2;
}

void AssignValues(vtkDoubleArray* to, const double* begin, std::size_t count)
{
  to->SetNumberOfTuples(static_cast<vtkIdType>(count));
  std::copy_n(begin, count, to->GetPointer(0));
}

}

//------------------------------------------------------------------------------
vtkTemporalIsosurfaceRepresentation::vtkTemporalIsosurfaceRepresentation()
{
  const auto mapper = vtkSmartPointer<vtkTemporalCoherenceVolumeMapper>::New();
  mapper->AddObserver(vtkCommand::VolumeMapperRenderEndEvent, this,
    &vtkTemporalIsosurfaceRepresentation::TakeStatistics);
  mapper->WarnOfIsovaluesOff(); // it knows one process's samples: see ShowIsovalues
  mapper->SetLabelTable(this->LabelTable);
  this->VolumeMapper = mapper;
  this->Actor = vtkSmartPointer<vtkTemporalIsosurfaceActor>::New();
  this->Actor->SetProperty(this->Property);
  this->Actor->SetLODMapper(this->OutlineMapper);
  this->Property->SetShade(1);
  this->Property->SetInterpolationTypeToLinear();
  this->RouteCounts->SetNumberOfTuples(NumberOfRoutes);
  this->RouteCounts->Fill(0);
  this->SetSolidColor(1.0, 1.0, 1.0);
  this->SetOpacity(1.0);
  this->StatisticsText->SetVisibility(0);
  this->StatisticsText->SetPosition(10.0, 10.0);
  this->StatisticsText->GetTextProperty()->SetFontSize(16);
  this->StatisticsText->GetTextProperty()->ShadowOn();
}

//------------------------------------------------------------------------------
vtkTemporalIsosurfaceRepresentation::~vtkTemporalIsosurfaceRepresentation() = default;

//------------------------------------------------------------------------------
vtkTemporalCoherenceVolumeMapper* vtkTemporalIsosurfaceRepresentation::GetMapper()
{
  return static_cast<vtkTemporalCoherenceVolumeMapper*>(this->VolumeMapper.Get());
}

//------------------------------------------------------------------------------
/// After each frame of the mapper. Texts are drawn after it, so that they tell of the same frame.
/// After one that failed, all numbers are still those of the last.
void vtkTemporalIsosurfaceRepresentation::TakeStatistics(vtkObject*, unsigned long, void* isMade)
{
  if (!*static_cast<const bool*>(isMade))
  {
    return;
  }
  vtkTemporalCoherenceVolumeMapper* mapper = this->GetMapper();
  const vtkIdType route = mapper->GetStatistics()->GetRoute();
  this->RouteCounts->SetValue(route, this->RouteCounts->GetValue(route) + 1);
  if (this->ShowStatistics)
  {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << mapper->GetStatistics()->GetRouteAsString()
         << ", " << this->GetFrameMilliseconds() << " ms\n"
         << mapper->GetStatistics()->GetNumberOfTracedRays() << " of "
         << mapper->GetStatistics()->GetNumberOfRays() << " rays traced\nisomap "
         << static_cast<double>(mapper->GetStatistics()->GetIsomapMemory()) / (1 << 20) << " MiB";
    this->StatisticsText->SetInput(text.str().c_str());
  }
}

//------------------------------------------------------------------------------
bool vtkTemporalIsosurfaceRepresentation::AddToView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (renderView)
  {
    renderView->GetNonCompositedRenderer()->AddActor(this->StatisticsText);
    this->Refiner->SetRenderWindow(renderView->GetRenderWindow());
  }
  return this->Superclass::AddToView(view);
}

//------------------------------------------------------------------------------
bool vtkTemporalIsosurfaceRepresentation::RemoveFromView(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  if (renderView)
  {
    renderView->GetNonCompositedRenderer()->RemoveActor(this->StatisticsText);
    this->Refiner->SetRenderWindow(nullptr);
  }
  return this->Superclass::RemoveFromView(view);
}

//------------------------------------------------------------------------------
int vtkTemporalIsosurfaceRepresentation::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->Superclass::RequestUpdateExtent(request, inputVector, outputVector))
  {
    return 0;
  }
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  if (input && controller && controller->GetNumberOfProcesses() > 1)
  {
    input->Set(
      vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), this->CountGhostLayers());
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkTemporalIsosurfaceRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->DataSize = 0;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  vtkDataObject* input = inputVector[0]->GetNumberOfInformationObjects() == 1
    ? vtkDataObject::GetData(inputVector[0], 0)
    : nullptr;
  DistributedPart part;
  if (input)
  {
    NeededData needed = WithGhostCells(input, this->CountGhostLayers(), controller);
    const bool areExchanged = needed.HasMeshes && this->IsTranslucent() && !IsAlone(controller);
    if (areExchanged && vtkCompositeDataSet::SafeDownCast(needed.Data))
    {
      needed.Data =
        Merge(needed.Data, { this->ChooseArray(needed.Data), this->ArrayChosenFor(ColorArray) });
    }
    this->HasMeshes = needed.HasMeshes;
    this->Cache = needed.Data;
    part = Describe(needed, this->ChooseArray(this->Cache), controller);
    part.WriteTo(this->Cache);
    this->NumberOfComponents = static_cast<int>(part.Ranges.size());
    this->DataSize = this->Cache->GetActualMemorySize();
    this->Actor->SetEnableLOD(0);
  }
  else
  {
    // A process without data, as a client is: it shows the outline.
    this->Cache = vtkSmartPointer<vtkPartitionedDataSet>::New();
    this->VolumeMapper->RemoveAllInputs();
    this->Actor->SetEnableLOD(1);
  }
  vtkMath::UninitializeBounds(this->DataBounds);
  if (part.Owned.IsValid())
  {
    part.Owned.GetBounds(this->DataBounds);
  }
  this->OutlineSource->SetBounds(this->DataBounds);
  this->OutlineSource->Update();
  // What the direct superclass adds is done above.
  return this->vtkVolumeRepresentation::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkTemporalIsosurfaceRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->Superclass::ProcessViewRequest(request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    // Opaque surfaces have depths, by which pictures can be put together in any order.
    outInfo->Set(vtkPVRenderView::NEED_ORDERED_COMPOSITING(), this->IsTranslucent() ? 1 : 0);
    if (this->Cache && this->HasMeshes)
    {
      // Parts of meshes may reach around one another: for translucent ones cells are exchanged.
      vtkPVRenderView::SetOrderedCompositingConfiguration(inInfo, this,
        vtkPVRenderView::DATA_IS_REDISTRIBUTABLE | vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
ArrayChoice vtkTemporalIsosurfaceRepresentation::ChooseArray(vtkDataObject* data)
{
  for (const int index : { SurfaceArray, ColorArray })
  {
    const ArrayChoice chosen = this->ArrayChosenFor(index);
    if (!chosen.Name.empty())
    {
      return chosen;
    }
  }
  for (vtkDataSet* dataSet : DataSetsOf(data))
  {
    const ArrayChoice choice = FirstScalars(dataSet);
    if (!choice.Name.empty())
    {
      return choice;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::UpdateMapperParameters()
{
  this->Superclass::UpdateMapperParameters();
  vtkDataObject* data = this->VolumeMapper->GetDataObjectInput();
  if (!data)
  {
    return;
  }
  const ArrayChoice choice = this->ChooseArray(data);
  const DistributedPart part = DistributedPart::ReadFrom(data);
  const std::vector<vtkDataSet*> dataSets = DataSetsOf(data);
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  this->ShowScalars(choice);
  this->ShowRegion(part);
  std::string mistake = this->FindMistakeInLabels(part, choice.Name);
  this->Actor->SetVisibility(mistake.empty() &&
    std::any_of(dataSets.begin(), dataSets.end(),
      [&](vtkDataSet* dataSet)
      { return choice.In(dataSet) != nullptr && (IsAlone(controller) || HasVolume(dataSet)); }));
  if (part.Ranges.empty() && part.Whole.IsValid())
  {
    const bool isOfSurfaces = !this->ArrayChosenFor(SurfaceArray).Name.empty();
    this->ReportOnce(choice.Name.empty()
        ? "The input has no array of numbers; give it one, for example with the filter Calculator."
        : SayMissing(choice, data, isOfSurfaces ? "SurfaceArrayName" : "ColorBy"));
    return;
  }
  const std::string mistakeInIsovalues =
    this->ShowIsovalues(this->RangeOfScalars(part), choice.Name);
  const std::string mistakeInLooks = this->ShowLooks(data, choice);
  for (const std::string& other :
    { mistakeInIsovalues, mistakeInLooks, this->FindMistakeInCuts(part) })
  {
    mistake = mistake.empty() ? other : mistake;
  }
  this->ReportOnce(mistake);
}

//------------------------------------------------------------------------------
/// \return a sentence about values that cannot be labels; empty if they can, or are none
std::string vtkTemporalIsosurfaceRepresentation::FindMistakeInLabels(
  const DistributedPart& part, const std::string& name)
{
  const bool areLengths = part.Ranges.size() > 1 &&
    this->GetMapper()->GetVectorMode() != vtkTemporalCoherenceVolumeMapper::COMPONENT;
  if (!this->AreLabelsDrawn() || (part.HoldsLabels && !areLengths))
  {
    return "";
  }
  return "'" + name +
    "' cannot be drawn as labels, which are whole numbers on an image; choose another array or "
    "SurfaceMode, or make whole numbers with the filter Calculator (ResultArrayType Int).";
}

//------------------------------------------------------------------------------
std::string vtkTemporalIsosurfaceRepresentation::FindMistakeInCuts(const DistributedPart& part)
{
  const int mode = this->GetMapper()->GetSurfaceMode();
  if (!part.IsCut || mode == vtkTemporalCoherenceVolumeMapper::CROSSING || !this->IsTranslucent())
  {
    return "";
  }
  return this->AreLabelsDrawn()
    ? "Translucent labels show where processes' parts are cut; give each label an opacity of 0 or "
      "1."
    : "Translucent solids show where processes' parts are cut; choose the SurfaceMode Crossing, "
      "or an Opacity of 1 without UseOpacityFunction.";
}

//------------------------------------------------------------------------------
/// Choose array and component; where nothing tells the component, lengths are drawn of tuples.
void vtkTemporalIsosurfaceRepresentation::ShowScalars(const ArrayChoice& choice)
{
  vtkTemporalCoherenceVolumeMapper* mapper = this->GetMapper();
  mapper->SelectScalarArray(choice.Name.c_str());
  mapper->SetScalarMode(
    choice.IsOnCells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  const int component = this->SurfaceComponent();
  mapper->SetVectorComponent(std::max(component, 0));
  mapper->SetVectorMode(component >= 0 ? vtkTemporalCoherenceVolumeMapper::COMPONENT
                                       : vtkTemporalCoherenceVolumeMapper::MAGNITUDE);
}

//------------------------------------------------------------------------------
std::array<double, 2> vtkTemporalIsosurfaceRepresentation::RangeOfScalars(
  const DistributedPart& part)
{
  vtkTemporalCoherenceVolumeMapper* mapper = this->GetMapper();
  const auto component = static_cast<std::size_t>(mapper->GetVectorComponent());
  if (part.Ranges.size() == 1)
  {
    return part.Ranges.front();
  }
  return mapper->GetVectorMode() == vtkTemporalCoherenceVolumeMapper::COMPONENT &&
      component < part.Ranges.size()
    ? part.Ranges[component]
    : part.Lengths;
}

//------------------------------------------------------------------------------
/// ParaView sets the single isovalue and those of the volume representation without being asked, to
/// the middle of an array that need not be the one that is drawn. So they count only where they fit
/// it, and the single one only if it was not that middle before.
/// \param range of the values; first larger than second if it is not known
std::vector<double> vtkTemporalIsosurfaceRepresentation::ChooseIsovalues(
  const std::array<double, 2>& range)
{
  if (!this->Isovalues.empty())
  {
    return this->Isovalues;
  }
  const bool isKnown = range[0] <= range[1];
  const double middle = 0.5 * (range[0] + range[1]);
  const auto fits = [&](double isovalue) { return isovalue >= range[0] && isovalue <= range[1]; };
  if (std::abs(this->SingleIsovalue - middle) <= 1e-6 * (range[1] - range[0]))
  {
    this->Untouched = this->SingleIsovalue;
  }
  if (fits(this->SingleIsovalue) && this->SingleIsovalue != this->Untouched)
  {
    return { this->SingleIsovalue };
  }
  return isKnown && std::none_of(this->VolumeIsovalues.begin(), this->VolumeIsovalues.end(), fits)
    ? std::vector<double>{ middle }
    : this->VolumeIsovalues;
}

//------------------------------------------------------------------------------
/// \return a sentence about isovalues that no process has; empty if there are none
std::string vtkTemporalIsosurfaceRepresentation::ShowIsovalues(
  const std::array<double, 2>& range, const std::string& name)
{
  const bool isKnown = range[0] <= range[1];
  std::vector<double> shown;
  std::ostringstream outside;
  const std::vector<double> chosen =
    this->AreLabelsDrawn() ? std::vector<double>() : this->ChooseIsovalues(range);
  for (const double isovalue : chosen)
  {
    const bool isFinite = std::isfinite(isovalue);
    if (isFinite)
    {
      shown.push_back(isovalue);
    }
    if (!isFinite || (isKnown && !(isovalue >= range[0] && isovalue <= range[1])))
    {
      outside << (outside.str().empty() ? "" : ", ") << isovalue;
    }
  }
  // What is not finite would be an error of the mapper, beside the message that this returns.
  vtkContourValues* contours = this->Property->GetIsoSurfaceValues();
  contours->SetNumberOfContours(static_cast<int>(shown.size()));
  for (std::size_t i = 0; i < shown.size(); ++i)
  {
    contours->SetValue(static_cast<int>(i), shown[i]);
  }
  AssignValues(this->ShownIsovalues, shown.data(), shown.size());
  AssignValues(this->ScalarRange, range.data(), isKnown ? 2 : 0);

  std::ostringstream message;
  if (!outside.str().empty())
  {
    message << "No isosurface of '" << name << "' has the isovalue " << outside.str() << "; give ";
    if (isKnown)
    {
      message << "Isovalues between " << range[0] << " and " << range[1] << ".";
    }
    else
    {
      message << "finite Isovalues.";
    }
  }
  return message.str();
}

//------------------------------------------------------------------------------
/// Draw this process's part of the box that the user left.
void vtkTemporalIsosurfaceRepresentation::ShowRegion(const DistributedPart& part)
{
  if (this->Crops || part.IsCut)
  {
    double planes[6];
    for (int i = 0; i < 6; ++i)
    {
      const double own = part.Crop.GetBound(i);
      const double users =
        this->CroppingOrigin[i / 2] + part.Whole.GetBound(i) * this->CroppingScale[i / 2];
      const double inner = i % 2 ? std::min(own, users) : std::max(own, users);
      planes[i] = this->Crops && part.IsCut ? inner : this->Crops ? users : own;
    }
    this->VolumeMapper->SetCroppingRegionPlanes(planes);
  }
  this->VolumeMapper->SetCropping(this->Crops || part.IsCut);
}

//------------------------------------------------------------------------------
/// Say a sentence once, in one process; an empty one says that all is well.
void vtkTemporalIsosurfaceRepresentation::ReportOnce(const std::string& message)
{
  if (message == this->LastMessage)
  {
    return;
  }
  this->LastMessage = message;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (!message.empty() && (!controller || controller->GetLocalProcessId() == 0))
  {
    vtkWarningMacro(<< message);
  }
}

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UseOpacityFunction: " << this->UseOpacityFunction << "\n";
  os << indent << "Opacity: " << this->Opacity << "\n";
  os << indent << "Mapper:\n";
  this->VolumeMapper->PrintSelf(os, indent.GetNextIndent());
}
