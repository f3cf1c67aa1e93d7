// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherenceViewWriter
 * @brief   writes pictures of isosurfaces for every isovalue: a page, a file, or a Cinema database
 *
 * A view is a picture of a volume for all isovalues of a range, within a stated tolerance. It needs
 * neither the volume nor a mapper to be shown. WriteView() writes
 * - a page (.html): one file for browsers, without a network, in which the reader drags the
 *   isovalue, turns the light, changes colours and reads depths;
 * - a view file (.tcview), which vtkTemporalCoherenceView reads (Documentation/ViewFile.md);
 * - a Cinema database (.cdb, a folder by specification D): images of depths and normals for some
 *   isovalues, with the view file beside them.
 *
 * Without AddView() it writes the view of the renderer's camera.
 *
 * @sa vtkTemporalCoherenceView, vtkTemporalCoherenceVolumeMapper
 */

#ifndef vtkTemporalCoherenceViewWriter_h
#define vtkTemporalCoherenceViewWriter_h

#include "vtkObject.h"
#include "vtkTemporalCoherenceCompatibility.h"
#include "vtkTemporalCoherenceModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
class vtkRenderer;
class vtkVolume;

class VTKTEMPORALCOHERENCE_EXPORT vtkTemporalCoherenceViewWriter : public vtkObject
{
public:
  static vtkTemporalCoherenceViewWriter* New();
  vtkTypeMacro(vtkTemporalCoherenceViewWriter, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set/Get the isovalues that are written, from the lowest to the highest. Isovalues beyond
   * the range of the data are left out. Default: none (1, 0), which takes those that leave out the
   * 5 % of surfaces with the lowest, and the 5 % with the highest isovalues.
   */
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  //@}

  //@{
  /**
   * Set/Get the largest error of distances, in voxels (default: 0.1; 0.02 to 10, other values are
   * clamped). Larger ones make smaller files.
   */
  vtkSetClampMacro(Tolerance, double, 0.02, 10.0);
  vtkGetMacro(Tolerance, double);
  //@}

  //@{
  /**
   * Set/Get the size of pictures in pixels (default: 1024 x 1024; 1 to 16384, other values are
   * clamped).
   */
  void SetSize(int width, int height);
  void SetSize(const int size[2]) { this->SetSize(size[0], size[1]); }
  vtkGetVector2Macro(Size, int);
  //@}

  //@{
  /** Set/Get what people read: UTF-8 texts (default: empty). The page shows them as they are. */
  void SetTitle(const char* text) { this->SetText(text, this->Title); }
  const char* GetTitle() const { return this->Title.c_str(); }
  void SetCaption(const char* text) { this->SetText(text, this->Caption); }
  const char* GetCaption() const { return this->Caption.c_str(); }
  void SetCitation(const char* text) { this->SetText(text, this->Citation); }
  const char* GetCitation() const { return this->Citation.c_str(); }
  void SetUnits(const char* text) { this->SetText(text, this->Units); }
  const char* GetUnits() const { return this->Units.c_str(); }
  //@}

  //@{
  /**
   * Set/Get how many isovalues a Cinema database has images of (default: 16; 2 to 1024, other
   * values are clamped). They are equally spaced in the range.
   */
  vtkSetClampMacro(NumberOfIsovalues, int, 2, 1024);
  vtkGetMacro(NumberOfIsovalues, int);
  //@}

  /**
   * Add a view. The camera is copied; its clipping range is set to hold the volume.
   * @param name of the view, in UTF-8; null: "View" and its number
   */
  void AddView(const char* name, vtkCamera* camera);
  /**
   * Add views around the focal point of a renderer's camera, in equal steps of azimuth.
   * @param count 1 to 64, the first one is that of the camera
   */
  void AddOrbit(int count, vtkRenderer* renderer);
  /** Forget the added views: the view of the renderer's camera is written again. */
  void RemoveAllViews();
  /** How many views were added; 0: the view of the renderer's camera is written. */
  int GetNumberOfViews() const;

  /**
   * Write the views of a volume.
   * @param path     ends in .html, .tcview or .cdb. An existing file is replaced when all is
   *                 written; a folder must not exist, or be a Cinema database
   * @param renderer its camera, lights and background are written
   * @param volume   with a vtkTemporalCoherenceVolumeMapper that draws isosurfaces of an image or a
   *                 rectilinear grid, with linear interpolation
   * @return false on error, which is reported, or if AbortExecute was set. ProgressEvent (with a
   *         double from 0 to 1) tells how far it is
   */
  bool WriteView(const char* path, vtkRenderer* renderer, vtkVolume* volume);

  //@{
  /** Set/Get whether WriteView() is to stop (default: 0, and when it begins). */
  vtkSetMacro(AbortExecute, vtkTypeBool);
  vtkGetMacro(AbortExecute, vtkTypeBool);
  vtkBooleanMacro(AbortExecute, vtkTypeBool);
  //@}

  //@{
  /**
   * About what was written last: bytes of the page or file, its number of knots, and the isovalues
   * of its first view. Before: 0, 0, and (1, 0).
   */
  vtkIdType GetBytesWritten() const { return this->BytesWritten; }
  vtkIdType GetNumberOfKnots() const { return this->NumberOfKnots; }
  vtkGetVector2Macro(WrittenRange, double);
  //@}

protected:
  vtkTemporalCoherenceViewWriter();
  ~vtkTemporalCoherenceViewWriter() override;

private:
  vtkTemporalCoherenceViewWriter(const vtkTemporalCoherenceViewWriter&) = delete;
  void operator=(const vtkTemporalCoherenceViewWriter&) = delete;

  void SetText(const char* text, std::string& setting);

  double Range[2] = { 1.0, 0.0 };
  double Tolerance = 0.1;
  int Size[2] = { 1024, 1024 };
  int NumberOfIsovalues = 16;
  std::string Title, Caption, Citation, Units;
  vtkTypeBool AbortExecute = 0;
  vtkIdType BytesWritten = 0, NumberOfKnots = 0;
  double WrittenRange[2] = { 1.0, 0.0 };

  struct Internals;
  std::unique_ptr<Internals> Internal;
};
VTK_ABI_NAMESPACE_END

#endif
