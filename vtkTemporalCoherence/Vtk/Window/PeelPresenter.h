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
/// of several volumes are merged here, by their depths. In the first round each volume draws the
/// merged layers of itself and of all volumes before it, and overwrites their colours. In later
/// rounds the last volume draws for all. The pass blends volumes of other mappers itself, but in
/// the first round a second volume of ours overwrites their colours, too.
class PeelPresenter
{
public:
  PeelPresenter();
  ~PeelPresenter();

  /// \param shown its number tells whether the textures of the last picture can be shown again
  /// \param error receives the mistake if the result is false
  bool Present(const PeelingPass& pass, vtkRenderer* renderer, vtkVolume* volume,
    const ShownFrame& shown, std::string& error);

  /// Free resources in the context of a window; in any context if it is null.
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Resources;
  bool Draw(const PeelingPass& pass, vtkVolume* volume, bool isInPlaceOfOthers, std::string& error);

  std::unique_ptr<Resources> OpenGL; ///< null without resources in a context
};

}

#endif
