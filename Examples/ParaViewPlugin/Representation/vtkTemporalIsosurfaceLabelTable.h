// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalIsosurfaceLabelTable
 * @brief   colours and opacities of labels, from what ParaView's colour maps hold
 *
 * It has a colour for each label. Of a categorical colour map (IndexedLookup), an annotated label
 * has the colour of its category, and any other label the NaN colour.
 */

#ifndef vtkTemporalIsosurfaceLabelTable_h
#define vtkTemporalIsosurfaceLabelTable_h

#include "vtkScalarsToColors.h"
#include "vtkSmartPointer.h" // For vtkSmartPointer

#include <map> // For std::map

class vtkColorTransferFunction;
class vtkPiecewiseFunction;

class vtkTemporalIsosurfaceLabelTable : public vtkScalarsToColors
{
public:
  static vtkTemporalIsosurfaceLabelTable* New();
  vtkTypeMacro(vtkTemporalIsosurfaceLabelTable, vtkScalarsToColors);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The colour map.
   */
  void SetColors(vtkColorTransferFunction* colors);

  /**
   * The opacities of labels, unless they have one of their own, or their category has one: these
   * count if the colour map is categorical and has EnableOpacityMapping.
   */
  void SetOpacities(vtkPiecewiseFunction* opacities);

  /**
   * Opacities of single labels, which count first.
   */
  void SetOwnOpacities(const std::map<double, double>& opacities);

  /**
   * True if a label may have an opacity between 0 and 1.
   */
  bool MayBeTranslucent();

  void GetColor(double label, double rgb[3]) override;
  double GetOpacity(double label) override;
  void Build() override;
  vtkMTimeType GetMTime() override;

protected:
  vtkTemporalIsosurfaceLabelTable();
  ~vtkTemporalIsosurfaceLabelTable() override;

private:
  vtkTemporalIsosurfaceLabelTable(const vtkTemporalIsosurfaceLabelTable&) = delete;
  void operator=(const vtkTemporalIsosurfaceLabelTable&) = delete;

  bool HasOpacitiesOfCategories();
  void GetCategory(double label, double rgba[4]);

  vtkSmartPointer<vtkColorTransferFunction> Colors;
  vtkSmartPointer<vtkPiecewiseFunction> Opacities;
  std::map<double, double> OwnOpacities;
};

#endif
