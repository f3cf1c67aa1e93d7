// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutOfCore/BrickArray.h"

#include "OutOfCore/OutOfCoreVolume.h"
#include "OutOfCore/VolumeOfArray.h"
#include "Scene/DefaultInitAllocator.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkGenericDataArray.h>
#include <vtkImageData.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <vector>

namespace TemporalCoherence
{
namespace
{

std::int64_t CountOfSamples(const glm::ivec3& dimensions)
{
  return static_cast<std::int64_t>(dimensions.x) * dimensions.y * dimensions.z;
}

/// Values of a volume in bricks.
template <typename T>
class BrickArray : public vtkGenericDataArray<BrickArray<T>, T>
{
public:
  using Self = BrickArray<T>;
  using Base = vtkGenericDataArray<BrickArray<T>, T>;
  using ValueType = T;
  vtkAbstractTemplateTypeMacro(Self, Base);
  vtkAOSArrayNewInstanceMacro(Self); // copies have samples of their own

  static BrickArray* New() { VTK_STANDARD_NEW_BODY(BrickArray); }

  void Show(const std::shared_ptr<const OutOfCoreVolume>& volume)
  {
    this->Volume = volume;
    this->Size = CountOfSamples(volume->Level().Dimensions);
    this->MaxId = this->Size - 1;
    this->Modified();
  }

  ValueType GetValue(vtkIdType index) const
  {
    const glm::i64vec3 size(this->Volume->Level().Dimensions);
    const SampleUse use;
    return *this->Volume->Bricks()->template At<T>(static_cast<int>(index % size.x),
      static_cast<int>(index / size.x % size.y), static_cast<int>(index / (size.x * size.y)));
  }
  ValueType GetTypedComponent(vtkIdType tuple, int) const { return this->GetValue(tuple); }
  void GetTypedTuple(vtkIdType index, ValueType* tuple) const { *tuple = this->GetValue(index); }

  /// The address of a copy of all samples: some filters ask for it. The copy is made once.
  void* GetVoidPointer(vtkIdType index) override
  {
    try
    {
      if (this->Whole.empty())
      {
        this->Whole.resize(static_cast<std::size_t>(this->Size));
        this->Volume->ReadAll(this->Whole.data());
      }
      return this->Whole.data() + index;
    }
    catch (const std::bad_alloc&)
    {
      vtkErrorMacro("There is not enough memory for all "
        << this->Size
        << " samples, whose address a filter asks for; use a coarser level of the volume.");
      return nullptr;
    }
  }

  void SetValue(vtkIdType, ValueType) { this->Refuse(); }
  void SetTypedComponent(vtkIdType, int, ValueType) { this->Refuse(); }
  void SetTypedTuple(vtkIdType, const ValueType*) { this->Refuse(); }
  bool AllocateTuples(vtkIdType) { return this->Refuse(); }
  bool ReallocateTuples(vtkIdType) { return this->Refuse(); }

protected:
  BrickArray() = default;
  ~BrickArray() override = default;

  bool ComputeScalarRange(double* ranges) override
  {
    const KnownRanges& known = *this->Volume->Ranges();
    ranges[0] = known.Whole.x;
    ranges[1] = known.Whole.y;
    return true;
  }
  bool ComputeFiniteScalarRange(double* ranges) override
  {
    const KnownRanges& known = *this->Volume->Ranges();
    ranges[0] = known.Finite.x;
    ranges[1] = known.Finite.y;
    return true;
  }

private:
  bool Refuse()
  {
    vtkErrorMacro(
      "The samples of a volume that is read in bricks cannot be changed; copy the array "
      "(DeepCopy) to change its values.");
    return false;
  }

  std::shared_ptr<const OutOfCoreVolume> Volume;
  std::vector<ValueType, DefaultInitAllocator<ValueType>> Whole; ///< empty: nobody asked for it
};

template <typename T>
vtkSmartPointer<vtkDataArray> MakeArrayOf(const std::shared_ptr<const OutOfCoreVolume>& volume)
{
  if (const void* const samples = volume->Mapped())
  {
    const auto array = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(vtkTypeTraits<T>::VTKTypeID()));
    // VTK has no arrays of constants. Nobody may write into a mapped file: it is mapped for
    // reading.
    array->SetVoidArray(const_cast<void*>(samples), CountOfSamples(volume->Level().Dimensions), 1);
    return array;
  }
  const auto array = vtkSmartPointer<BrickArray<T>>::New();
  array->Show(volume);
  return array;
}

}

vtkSmartPointer<vtkDataArray> MakeArray(const std::shared_ptr<const OutOfCoreVolume>& volume)
{
  const auto array = DispatchScalarType(
    volume->File().Type(), [&](auto type) { return MakeArrayOf<decltype(type)>(volume); });
  SetVolume(array, volume);
  return array;
}

vtkSmartPointer<vtkImageData> MakeCoarseImage(const OutOfCoreVolume& volume)
{
  const std::shared_ptr<const StandIn>& coarse = volume.Coarse();
  if (!coarse)
  {
    return nullptr;
  }
  const Field& field = coarse->Samples;
  const VolumeLevel& level = volume.Level();
  const glm::dvec3 spacing = coarse->Step * level.Spacing;
  const glm::dvec3 origin = level.Origin + coarse->First * level.Spacing;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(&field.Dimensions.x);
  image->SetSpacing(&spacing.x);
  image->SetOrigin(&origin.x);
  DispatchScalarType(field.Type,
    [&](auto type)
    {
      using T = decltype(type);
      image->AllocateScalars(vtkTypeTraits<T>::VTKTypeID(), 1);
      std::copy_n(static_cast<const T*>(field.Samples), CountOfSamples(field.Dimensions),
        static_cast<T*>(image->GetScalarPointer()));
    });
  return image;
}

}
