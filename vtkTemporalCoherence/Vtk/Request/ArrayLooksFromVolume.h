// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ArrayLooksFromVolume_h
#define TemporalCoherence_ArrayLooksFromVolume_h

#include "Input/ScalarChoice.h"
#include "Request/AppearanceFromVolume.h"
#include "Request/FieldFromMapper.h"
#include "Scene/FrameKey.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkObject.h>
#include <vtkScalarsToColors.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkVolume;
class vtkVolumeProperty;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The array that gives surfaces their colours, and its table.
struct ArrayLookSettings
{
  ArrayChoice Array;
  vtkSmartPointer<vtkScalarsToColors> Table; ///< null: the functions of the property
  bool HasOpacity = false;                   ///< gives opacities, too
};

/// Makes the looks of surfaces by an array. Keeps those of a table until it changes.
class ArrayLooksFromVolume
{
public:
  /// Give the surfaces of a key their opacities and, for a viewer, their colours.
  /// \param fields    have made the field of the key
  /// \param component of the property, for its functions
  /// \param read      receives arrays that must stay alive during the frame, besides others
  /// \param error     receives the mistake and its remedy
  /// \return false on error
  bool Make(FieldFromMapper& fields, const ArrayLookSettings& settings, int component,
    vtkVolume* volume, bool hasViewer, FrameKey& key,
    std::vector<vtkSmartPointer<vtkObjectBase>>& read, std::string& error);

  /// True if no value of the array makes a surface translucent.
  bool AreOpaque(const ArrayLookSettings& settings, vtkVolumeProperty* property, int component);

private:
  /// A table of looks, and the VTK object that it was made of.
  template <typename Look>
  struct MadeTable
  {
    /// True if an object is its source, unchanged since.
    bool IsOf(vtkObject* object) const
    {
      return this->Of == object && this->Time == object->GetMTime();
    }

    std::shared_ptr<const ValueTable<Look>> Looks;
    vtkSmartPointer<vtkObject> Of; ///< null: none is made
    vtkMTimeType Time = 0;
  };

  bool FindColors(const SurfaceLooks& looks, std::string& error);
  bool FindOpacities(const SurfaceLooks& looks, std::string& error);

  MadeTable<glm::vec3> Colors;
  MadeTable<float> Opacities; ///< without looks if all are 1
};

}

#endif
