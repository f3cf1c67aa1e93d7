// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherenceView
 * @brief   reads view files, and looks up any isovalue in them without the volume
 *
 * Read() takes a view file (.tcview) or a page (.html) that vtkTemporalCoherenceViewWriter wrote.
 * LookUp() makes an image of depths and normals for an isovalue. Depths are those of a mapper's
 * isomap of the same tolerance, bit for bit, wherever that isomap can answer without tracing a ray.
 *
 * @sa vtkTemporalCoherenceViewWriter
 */

#ifndef vtkTemporalCoherenceView_h
#define vtkTemporalCoherenceView_h

#include "vtkObject.h"
#include "vtkTemporalCoherenceCompatibility.h"
#include "vtkTemporalCoherenceModule.h" // For export macro

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;

class VTKTEMPORALCOHERENCE_EXPORT vtkTemporalCoherenceView : public vtkObject
{
public:
  static vtkTemporalCoherenceView* New();
  vtkTypeMacro(vtkTemporalCoherenceView, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Read a file. All of it is checked first.
   * @return false on error, which is reported; the views read before are then kept
   */
  bool Read(const char* path);

  //@{
  /** What the file says; empty, or 0, before one is read. */
  int GetNumberOfViews() const;
  const char* GetTitle() const;
  const char* GetCaption() const;
  const char* GetCitation() const;
  const char* GetUnits() const;
  /** Its header, as JSON (Documentation/ViewFile.md). */
  const char* GetHeader() const;
  //@}

  //@{
  /**
   * About a view.
   * @param view from 0 to GetNumberOfViews() - 1. Others have no name, an empty range (1, 0), and
   *             no pixels
   */
  const char* GetViewName(int view) const;
  void GetRange(int view, double range[2]) const;
  void GetSize(int view, int size[2]) const;
  /** Largest error of distances, in voxels. */
  double GetTolerance(int view) const;
  vtkIdType GetNumberOfKnots(int view) const;
  //@}

  /**
   * Look up an isovalue.
   * @param view     from 0 to GetNumberOfViews() - 1
   * @param isovalue in the range of the view
   * @param image    gets the arrays Depth (float, world distance along the ray; infinity without a
   *                 surface), Normals (float, 3), IsovalueIndex and Answer of
   *                 vtkTemporalCoherenceVolumeMapper::MakeImage. Answer is 2 where the
   *                 surface is too close to a jump or too steep to be sure: there a mapper traces
   *                 the ray
   * @return false on error, which is reported
   */
  bool LookUp(int view, double isovalue, vtkImageData* image);

protected:
  vtkTemporalCoherenceView();
  ~vtkTemporalCoherenceView() override;

private:
  vtkTemporalCoherenceView(const vtkTemporalCoherenceView&) = delete;
  void operator=(const vtkTemporalCoherenceView&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};
VTK_ABI_NAMESPACE_END

#endif
