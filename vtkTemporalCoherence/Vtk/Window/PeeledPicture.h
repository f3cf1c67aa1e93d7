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

/// The merged layers of all volumes of a renderer while a picture is peeled. It is stored in the
/// renderer's information, where independent mappers find it.
class PeeledPicture : public vtkObject
{
public:
  static PeeledPicture* New();
  vtkTypeMacro(PeeledPicture, vtkObject);

  /// The peeled picture of a renderer, made if it has none.
  static vtkSmartPointer<PeeledPicture> Of(vtkRenderer* renderer);

  /// Add a frame to the picture that a pass is drawing.
  /// \param who  adds it
  /// \param size pixels of the viewport
  /// \throws std::bad_alloc
  void Add(const PeelingPass& pass, const void* who, const glm::ivec2& size, const Frame& frame,
    const View& view);

  /// The one that draws for all: the last one that added a frame.
  bool IsDrawnBy(const void* who) const { return this->Last == who; }

  const PeeledLayers& Layers() const { return this->All; }

  /// Free the memory of the layers. No frame can be added afterwards.
  void ReleaseLayers() { this->All = PeeledLayers(); }

private:
  PeeledLayers All;
  const void* Pass = nullptr;
  vtkMTimeType Time = 0; ///< of the pass
  const void* Last = nullptr;
};

}

#endif
