// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_MeshPeers_h
#define Benchmarks_MeshPeers_h

#include "Stage.h"

#include <memory>
#include <string>
#include <vector>

class vtkCamera;

/// Ways to draw an isosurface of an irregular grid, this mapper among them. Each has a camera of
/// its own, so that they can be measured in turn.
namespace MeshPeers
{

/// A mesh, and how it is looked at.
struct Subject
{
  std::string Name;
  double Isovalue;
  int Size; ///< pixels in each direction
  Framing From;
  vtkSmartPointer<vtkDataSet> Mesh;
};

class Way
{
public:
  explicit Way(const std::string& who)
    : Who(who)
  {
  }
  virtual ~Way() = default;

  virtual void SetIsovalue(double isovalue) = 0;
  virtual void SetCamera(vtkCamera* camera) = 0;

  /// Milliseconds.
  virtual double Draw() = 0;

  /// The mapper and its last picture, if this way is drawn by it.
  virtual const Drawer* Ours() const { return nullptr; }

  /// The same picture cold; None for others.
  virtual double DrawCold();

  virtual double PercentDrawn() = 0;

  const std::string Who;
  std::string Remark;  ///< what else was needed before the first frame; may be empty
  double Memory = 0.0; ///< bytes beside the mesh that frames are made from; may be None
  int SlowerBy = 1;    ///< it is drawn in one of so many rounds only
};

/// The first is the mapper; peers that do not draw this kind of mesh are left out.
/// \param hasWindow false: polygons are made, but not drawn
std::vector<std::unique_ptr<Way>> All(const Subject& subject, bool hasWindow);

}

#endif
