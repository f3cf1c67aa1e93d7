// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PeelPresenter_h
#define TemporalCoherence_PeelPresenter_h

#include "Scene/Frame.h"
#include "Scene/View.h"
#include "Window/PeelingPass.h"
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

/// Draws a finished frame where volumes are peeled: of the surfaces behind one another at a pixel,
/// those between two depths, as the pass asks for them.
///
/// The pass takes the larger of two volumes' colours where they lie in one slab. So pictures of
/// several volumes are put together here, by their depths: who is drawn later draws all that were
/// before, and from the second time on the last one draws for all.
class PeelPresenter
{
public:
  PeelPresenter();
  ~PeelPresenter();

  /// \param error gets what is wrong if the result is false
  bool Present(const PeelingPass& pass, vtkRenderer* renderer, vtkVolume* volume,
    const Frame& frame, const View& view, std::string& error);

  /// Free what is held in the context of a window; in any, if it is null.
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Resources;
  bool Draw(const PeelingPass& pass, vtkVolume* volume, std::string& error);

  std::unique_ptr<Resources> OpenGL; ///< null while nothing is held in a context
};

}

#endif
