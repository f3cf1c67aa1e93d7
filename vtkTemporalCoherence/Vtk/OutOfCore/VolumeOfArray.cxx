// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutOfCore/VolumeOfArray.h"

#include "OutOfCore/OutOfCoreVolume.h"

#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkInformationObjectBaseKey.h>
#include <vtkObjectFactory.h>
#include <vtkSmartPointer.h>

namespace TemporalCoherence
{
namespace
{

/// The volume of an array, for its information: writers of files leave objects out.
class VolumeHolder : public vtkObject
{
public:
  static VolumeHolder* New();
  vtkTypeMacro(VolumeHolder, vtkObject);

  static vtkInformationObjectBaseKey* Key()
  {
    static vtkInformationObjectBaseKey* const key =
      vtkInformationObjectBaseKey::MakeKey("OUT_OF_CORE", "vtkTemporalCoherenceVolumeMapper");
    return key;
  }

  std::shared_ptr<const OutOfCoreVolume> Volume;
  const vtkDataArray* Array = nullptr; ///< copies of an array share its information
};

vtkStandardNewMacro(VolumeHolder);

}

void SetVolume(vtkDataArray* array, const std::shared_ptr<const OutOfCoreVolume>& volume)
{
  const auto holder = vtkSmartPointer<VolumeHolder>::New();
  holder->Volume = volume;
  holder->Array = array;
  array->GetInformation()->Set(VolumeHolder::Key(), holder);
}

std::shared_ptr<const OutOfCoreVolume> VolumeOf(vtkDataArray* array)
{
  const auto* const holder = array && array->HasInformation()
    ? VolumeHolder::SafeDownCast(array->GetInformation()->Get(VolumeHolder::Key()))
    : nullptr;
  return holder && holder->Array == array ? holder->Volume : nullptr;
}

bool AreInBricks(vtkDataArray* array)
{
  const auto volume = VolumeOf(array);
  return volume && volume->Bricks();
}

}
