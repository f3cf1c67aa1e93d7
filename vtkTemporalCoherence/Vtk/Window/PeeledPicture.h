// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PeeledPicture_h
#define TemporalCoherence_PeeledPicture_h

#include "Window/PeeledLayers.h"
#include "Window/PeelingPass.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkObject.h>
#include <vtkSmartPointer.h>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// What the volumes of a renderer show together in a picture that is being peeled. The renderer
/// keeps it, among its information, so that mappers that do not know one another find it.
class PeeledPicture : public vtkObject
{
public:
  static PeeledPicture* New();
  vtkTypeMacro(PeeledPicture, vtkObject);

  /// That of a renderer, which gets one if it has none.
  static vtkSmartPointer<PeeledPicture> Of(vtkRenderer* renderer);

  /// Lay a frame among those of the picture that a pass draws; it may be the first one.
  /// \param who  adds it
  /// \param size pixels of the viewport
  /// \throws std::bad_alloc
  void Add(const PeelingPass& pass, const void* who, const glm::ivec2& size, const Frame& frame,
    const View& view);

  /// Who draws for all: the last one that added a frame.
  bool IsDrawnBy(const void* who) const { return this->Last == who; }

  const PeeledLayers& Layers() const { return this->All; }

  /// Free the memory of the layers, to which nothing will be added any more.
  void ReleaseLayers() { this->All = PeeledLayers(); }

private:
  PeeledLayers All;
  const void* Pass = nullptr;
  vtkMTimeType Time = 0; ///< of the pass
  const void* Last = nullptr;
};

}

#endif
