// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherenceStatistics
 * @brief   route, counters, times and memory of a frame of vtkTemporalCoherenceVolumeMapper
 *
 * vtkTemporalCoherenceVolumeMapper::GetStatistics() returns it. Times are in seconds, memory is in
 * bytes. Before the first frame all numbers are 0. Documentation/Mapper.md explains the terms.
 */

#ifndef vtkTemporalCoherenceStatistics_h
#define vtkTemporalCoherenceStatistics_h

#include "vtkTemporalCoherenceCompatibility.h"
#include "vtkTemporalCoherenceModule.h" // For export macro

#include <vtkObject.h>

VTK_ABI_NAMESPACE_BEGIN
class VTKTEMPORALCOHERENCE_EXPORT vtkTemporalCoherenceStatistics : public vtkObject
{
public:
  static vtkTemporalCoherenceStatistics* New();
  vtkTypeMacro(vtkTemporalCoherenceStatistics, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * How the frame was made: one of vtkTemporalCoherenceVolumeMapper::Routes, or its name: Cold,
   * Redisplay, Reshade, IsomapLookup, IsomapBuild, ImageCache, TimeStep, Recomposite, KeepValues,
   * Antialias, FewerRays or Refine.
   */
  vtkGetMacro(Route, int);
  const char* GetRouteAsString() { return this->RouteName; }
  //@}

  //@{
  /**
   * Numbers of rays in the frame. A definite miss is known to meet nothing. A definite hit was
   * known before or predicted. Other rays are possible hits. Traced rays went through the field;
   * NumberOfFieldSamples counts the samples that were read.
   */
  vtkGetMacro(NumberOfRays, vtkIdType);
  vtkGetMacro(NumberOfDefiniteHits, vtkIdType);
  vtkGetMacro(NumberOfDefiniteMisses, vtkIdType);
  vtkGetMacro(NumberOfPossibleHits, vtkIdType);
  vtkGetMacro(NumberOfTracedRays, vtkIdType);
  vtkGetMacro(NumberOfFieldSamples, vtkIdType);
  //@}

  //@{
  /**
   * Number of composited surfaces (0 if all are opaque), and of surfaces merged into one in front.
   */
  vtkGetMacro(NumberOfLayers, vtkIdType);
  vtkGetMacro(NumberOfMergedLayers, vtkIdType);
  //@}

  //@{
  /** Memory of the view's isomap, in bytes, and its number of knots. */
  vtkGetMacro(IsomapMemory, vtkIdType);
  vtkGetMacro(NumberOfIsomapKnots, vtkIdType);
  //@}

  //@{
  /**
   * Seconds for the whole frame, for tracing rays, for querying a cached image, for building bands
   * of the isomap (after BuildIsomap(): for that call), for shading, and for drawing into the
   * window.
   */
  vtkGetMacro(FrameTime, double);
  vtkGetMacro(TraceTime, double);
  vtkGetMacro(QueryTime, double);
  vtkGetMacro(IsomapBuildTime, double);
  vtkGetMacro(ShadeTime, double);
  vtkGetMacro(PresentTime, double);
  //@}

  //@{
  /**
   * Set-up of the mesh: the work (one of vtkTemporalCoherenceVolumeMapper::MeshSetUps), its
   * seconds, the bytes of all kept structures, and whether cell scalars were averaged to points.
   */
  vtkGetMacro(MeshSetUp, int);
  vtkGetMacro(MeshSetUpTime, double);
  vtkGetMacro(MeshMemory, vtkIdType);
  vtkGetMacro(ScalarsWereAveraged, bool);
  //@}

  //@{
  /**
   * Curved cells (quadratic, Lagrange, Bezier) are divided into linear ones. MeshPointError bounds
   * the distance between both, as a share of the cell's diagonal. MeshValueError bounds the
   * difference of values, as a share of their range in the cell; it is NaN if samples between
   * corners are not finite. Both are 0 without curved cells: polyhedra, prisms and convex sets of
   * points are defined by their parts.
   */
  vtkGetMacro(MeshPointError, double);
  vtkGetMacro(MeshValueError, double);
  //@}

protected:
  vtkTemporalCoherenceStatistics() = default;
  ~vtkTemporalCoherenceStatistics() override = default;

private:
  vtkTemporalCoherenceStatistics(const vtkTemporalCoherenceStatistics&) = delete;
  void operator=(const vtkTemporalCoherenceStatistics&) = delete;

  friend class vtkTemporalCoherenceVolumeMapper; // writes them

  int Route = 0;
  const char* RouteName = "Cold";
  vtkIdType NumberOfRays = 0;
  vtkIdType NumberOfDefiniteHits = 0;
  vtkIdType NumberOfDefiniteMisses = 0;
  vtkIdType NumberOfPossibleHits = 0;
  vtkIdType NumberOfTracedRays = 0;
  vtkIdType NumberOfFieldSamples = 0;
  vtkIdType NumberOfLayers = 0;
  vtkIdType NumberOfMergedLayers = 0;
  vtkIdType IsomapMemory = 0;
  vtkIdType NumberOfIsomapKnots = 0;
  double FrameTime = 0.0;
  double TraceTime = 0.0;
  double QueryTime = 0.0;
  double IsomapBuildTime = 0.0;
  double ShadeTime = 0.0;
  double PresentTime = 0.0;
  int MeshSetUp = 0;
  double MeshSetUpTime = 0.0;
  vtkIdType MeshMemory = 0;
  bool ScalarsWereAveraged = false;
  double MeshPointError = 0.0;
  double MeshValueError = 0.0;
};
VTK_ABI_NAMESPACE_END

#endif
