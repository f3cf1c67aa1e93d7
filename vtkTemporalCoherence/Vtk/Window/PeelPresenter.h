// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PeelPresenter_h
#define TemporalCoherence_PeelPresenter_h

#include "Window/PeelingPass.h"
#include "Window/PicturePresenter.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <memory>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
class vtkVolume;
class vtkWindow;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Draws a finished frame in a pass that peels volumes: at each pixel the layers between the two
/// depths that the pass asks for.
///
/// If two volumes lie in the same slab, the pass blends their colours by the maximum. So the layers
/// of several volumes are merged here, by their depths. In the first round each volume draws its
/// layers with those of all volumes before it, in place of what these have drawn; afterwards the
/// last volume draws for all. Volumes of other mappers are blended as the pass
/// does it, but a second volume of ours replaces what they have drawn before it in the first round.
class PeelPresenter
{
public:
  PeelPresenter();
  ~PeelPresenter();

  /// \param shown its number tells whether the textures of the last picture can be shown again
  /// \param error gets what is wrong if the result is false
  bool Present(const PeelingPass& pass, vtkRenderer* renderer, vtkVolume* volume,
    const ShownFrame& shown, std::string& error);

  /// Free what is held in the context of a window; in any, if it is null.
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Resources;
  bool Draw(const PeelingPass& pass, vtkVolume* volume, bool isInPlaceOfOthers, std::string& error);

  std::unique_ptr<Resources> OpenGL; ///< null while nothing is held in a context
};

}

#endif
