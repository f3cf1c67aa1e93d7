// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalIsosurfaceRepresentation.h"

#include "DistributedPart.h"
#include "MergedMesh.h"

#include "vtkCellData.h"
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
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTemporalCoherenceRefiner.h"
#include "vtkTemporalCoherenceVolumeMapper.h"
#include "vtkTemporalIsosurfaceActor.h"
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
  vtkTemporalCoherenceVolumeMapper::ROUTE_REFINE + 1; // the last one

/// Arrays of numbers that could be drawn.
std::vector<vtkDataArray*> ArraysIn(vtkDataSetAttributes* attributes)
{
  std::vector<vtkDataArray*> arrays;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = attributes->GetArray(i);
    const char* name = array ? array->GetName() : nullptr;
    if (name && std::string(name) != vtkDataSetAttributes::GhostArrayName())
    {
      arrays.push_back(array);
    }
  }
  return arrays;
}

/// The scalars that a data set calls its own, or the first numbers that it has.
ArrayChoice FirstScalars(vtkDataSet* dataSet)
{
  for (const bool onCells : { false, true })
  {
    vtkDataSetAttributes* attributes = onCells
      ? static_cast<vtkDataSetAttributes*>(dataSet->GetCellData())
      : dataSet->GetPointData();
    vtkDataArray* found = attributes->GetScalars();
    const std::vector<vtkDataArray*> arrays = ArraysIn(attributes);
    if (!(found && found->GetName()) && !arrays.empty())
    {
      found = arrays.front();
    }
    if (found && found->GetName())
    {
      return { found->GetName(), onCells };
    }
  }
  return {};
}

/// The names of the arrays that could be chosen, for a message.
std::string NamesIn(vtkDataObject* data)
{
  std::set<std::string> names;
  for (vtkDataSet* dataSet : DataSetsOf(data))
  {
    for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
    {
      for (vtkDataArray* array : ArraysIn(dataSet->GetAttributes(association)))
      {
        names.insert(std::string("('") + (association == vtkDataObject::CELL ? "CELLS" : "POINTS") +
          "', '" + array->GetName() + "')");
      }
    }
  }
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

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
      vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), NumberOfGhostLayers);
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
    NeededData needed = WithGhostCells(input, controller);
    const bool areExchanged = needed.HasMeshes && this->IsTranslucent() && !IsAlone(controller);
    if (areExchanged && vtkCompositeDataSet::SafeDownCast(needed.Data))
    {
      needed.Data = Merge(needed.Data, this->ChooseArray(needed.Data));
    }
    this->HasMeshes = needed.HasMeshes;
    this->Cache = needed.Data;
    part = Describe(needed, this->ChooseArray(this->Cache), controller);
    part.WriteTo(this->Cache);
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
bool vtkTemporalIsosurfaceRepresentation::IsColoredByArray()
{
  vtkInformation* info = this->GetInputArrayInformation(0);
  const char* name = info ? info->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  return name && name[0];
}

//------------------------------------------------------------------------------
ArrayChoice vtkTemporalIsosurfaceRepresentation::ChooseArray(vtkDataObject* data)
{
  if (this->IsColoredByArray())
  {
    vtkInformation* info = this->GetInputArrayInformation(0);
    return { info->Get(vtkDataObject::FIELD_NAME()),
      info->Get(vtkDataObject::FIELD_ASSOCIATION()) == vtkDataObject::FIELD_ASSOCIATION_CELLS };
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
  this->Actor->SetVisibility(std::any_of(dataSets.begin(), dataSets.end(),
    [&](vtkDataSet* dataSet)
    { return choice.In(dataSet) != nullptr && (IsAlone(controller) || HasVolume(dataSet)); }));
  this->ShowScalars(choice);
  this->ShowRegion(part);
  if (part.Ranges.empty() && part.Whole.IsValid())
  {
    const std::string names = NamesIn(data);
    this->ReportOnce(choice.Name.empty()
        ? "The input has no array of numbers; give it one, for example with the filter Calculator."
        : std::string("The input has no ") + (choice.IsOnCells ? "cell" : "point") + " array '" +
          choice.Name + "'; choose one that it has with ColorBy: " + names + ".");
    return;
  }
  std::string mistake = this->ShowIsovalues(this->RangeOfScalars(part), choice.Name);
  this->ShowColors();
  if (mistake.empty() && part.IsCut && this->IsTranslucent() &&
    this->GetMapper()->GetSurfaceMode() == vtkTemporalCoherenceVolumeMapper::THRESHOLD)
  {
    mistake =
      "Translucent solids show where processes' parts are cut; choose the SurfaceMode Crossing, "
      "or an Opacity of 1 without UseOpacityFunction.";
  }
  this->ReportOnce(mistake);
}

//------------------------------------------------------------------------------
/// Choose array and component; without a lookup table that tells, lengths are drawn of tuples.
void vtkTemporalIsosurfaceRepresentation::ShowScalars(const ArrayChoice& choice)
{
  vtkTemporalCoherenceVolumeMapper* mapper = this->GetMapper();
  mapper->SelectScalarArray(choice.Name.c_str());
  mapper->SetScalarMode(
    choice.IsOnCells ? VTK_SCALAR_MODE_USE_CELL_FIELD_DATA : VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
  const bool isComponent = this->Table && this->IsColoredByArray() &&
    this->Table->GetVectorMode() == vtkScalarsToColors::COMPONENT;
  mapper->SetVectorComponent(isComponent ? this->Table->GetVectorComponent() : 0);
  mapper->SetVectorMode(isComponent ? vtkTemporalCoherenceVolumeMapper::COMPONENT
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
  for (const double isovalue : this->ChooseIsovalues(range))
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
void vtkTemporalIsosurfaceRepresentation::ShowColors()
{
  const bool hasTable = this->Table && this->IsColoredByArray();
  vtkColorTransferFunction* colors = hasTable ? this->Table.Get() : this->SolidColor.Get();
  const bool usesFunction = this->UseOpacityFunction && this->OpacityFunction;
  vtkPiecewiseFunction* opacities =
    usesFunction ? this->OpacityFunction.Get() : this->ConstantOpacity.Get();
  if (!this->SurfaceLooks.empty())
  {
    this->ShowSurfaceLooks(colors, opacities);
    colors = this->ColorsOfSurfaces;
    opacities = this->OpacitiesOfSurfaces;
  }
  this->Property->SetColor(colors);
  this->Property->SetScalarOpacity(opacities);
}

//------------------------------------------------------------------------------
/// Give the functions of surfaces a node at each isovalue that is drawn. They are left alone if
/// nothing is new, so that their pictures are used again.
/// \param colors, opacities of isovalues without a look
void vtkTemporalIsosurfaceRepresentation::ShowSurfaceLooks(
  vtkColorTransferFunction* colors, vtkPiecewiseFunction* opacities)
{
  std::map<double, Look> looks;
  const auto count = static_cast<std::size_t>(this->ShownIsovalues->GetNumberOfTuples());
  for (std::size_t i = 0; i < count; ++i)
  {
    const double isovalue = this->ShownIsovalues->GetValue(static_cast<vtkIdType>(i));
    Look look;
    if (i < this->SurfaceLooks.size())
    {
      look = this->SurfaceLooks[i];
    }
    else
    {
      colors->GetColor(isovalue, look.data());
      look[3] = opacities->GetValue(isovalue);
    }
    looks[isovalue] = look;
  }
  if (looks == this->LooksInFunctions)
  {
    return;
  }
  this->LooksInFunctions = looks;
  this->ColorsOfSurfaces->RemoveAllPoints();
  this->OpacitiesOfSurfaces->RemoveAllPoints();
  for (const auto& [isovalue, look] : looks)
  {
    this->ColorsOfSurfaces->AddRGBPoint(isovalue, look[0], look[1], look[2]);
    this->OpacitiesOfSurfaces->AddPoint(isovalue, look[3]);
  }
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
