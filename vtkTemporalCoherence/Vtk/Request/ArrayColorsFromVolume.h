// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ArrayColorsFromVolume_h
#define TemporalCoherence_ArrayColorsFromVolume_h

#include "Input/ScalarChoice.h"
#include "Request/AppearanceFromVolume.h"
#include "Request/FieldFromMapper.h"
#include "Scene/ArrayColors.h"
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
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The array that gives surfaces their colours, and its table.
struct ArrayColorSettings
{
  ArrayChoice Array;
  vtkSmartPointer<vtkScalarsToColors> Table; ///< null: the colour function of the property
};

/// Makes the colours of surfaces by an array. Keeps those of a table until it changes.
class ArrayColorsFromVolume
{
public:
  /// \param fields    have made the field whose surfaces are drawn
  /// \param component of the property, for its colour function
  /// \param colors    receives them
  /// \param read      receives arrays that must stay alive during the frame, besides others
  /// \param error     receives the mistake and its remedy
  /// \return false on error
  bool Make(FieldFromMapper& fields, const ArrayColorSettings& settings, int component,
    vtkVolume* volume, std::shared_ptr<const ArrayColors>& colors,
    std::vector<vtkSmartPointer<vtkObjectBase>>& read, std::string& error);

private:
  bool FindColors(const SurfaceLooks& looks, std::string& error);

  std::shared_ptr<const ValueColors> Known; ///< of the table
  vtkSmartPointer<vtkObject> Of;            ///< the table; null: none is known
  vtkMTimeType Time = 0;                    ///< of the table
};

}

#endif
