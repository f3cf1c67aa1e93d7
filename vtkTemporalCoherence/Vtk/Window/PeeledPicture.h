// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PeeledPicture_h
#define TemporalCoherence_PeeledPicture_h

#include "Window/PeeledLayers.h"
#include "Window/PeelingPass.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkObject.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

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

  /// Add the layers of a volume to the picture that a pass is drawing.
  /// \param who    adds them
  /// \param size   pixels of the viewport
  /// \param number of the volume's picture: different layers have different numbers in the whole
  ///               process
  void Add(const PeelingPass& pass, const void* who, const glm::ivec2& size, std::uint64_t number,
    std::shared_ptr<const PeeledLayers> layers);

  /// True for the last one that added layers: it draws for all.
  bool IsDrawnBy(const void* who) const { return this->Last == who; }

  /// How many volumes have added layers so far.
  std::size_t NumberOfVolumes() const { return this->Added.size(); }

  /// Equal numbers mean equal layers of the volumes so far, and an equal size of the viewport.
  const std::vector<std::uint64_t>& Numbers() const { return this->Identity; }

  /// The layers of the volumes so far.
  /// \throws std::bad_alloc
  const PeeledLayers& Merged();

  /// Free the memory of the layers. After that no layers can be added.
  void ReleaseLayers();

private:
  glm::ivec2 Size{ 0 };
  std::vector<std::shared_ptr<const PeeledLayers>> Added;
  std::vector<std::uint64_t> Identity;
  PeeledLayers All;             ///< the first NumberMerged of Added, merged
  std::size_t NumberMerged = 0; ///< of Added
  const void* Pass = nullptr;
  vtkMTimeType Time = 0; ///< of the pass
  const void* Last = nullptr;
};

}

#endif
