// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_IsovalueCheck_h
#define TemporalCoherence_IsovalueCheck_h

#include "Acceleration/ValueRangePyramid.h"
#include "Request/RequestFromMapper.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkDataObject.h>
#include <vtkVolume.h>
#include <vtkWeakPointer.h>

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
class vtkVolumeMapper;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// A mapper, and the volume and renderer that it draws for.
struct DrawnVolume
{
  vtkVolumeMapper* Mapper;
  vtkVolume* Volume;
  vtkRenderer* Renderer;
};

/// True if isovalues may be meant for more data than the mapper has: if its input is a piece of a
/// pipeline's data or one block of several, or if several volumes share the property. Reads ghost
/// arrays, which takes a while.
bool MaySeePartOnly(const DrawnVolume& drawn);

/// Warns of empty pictures that the user may not expect: of isovalues that no sample can meet, and
/// of VTK's default isovalue 0 if it is transparent. It warns once for each volume, and again only
/// after some isovalue was met. Isovalues that this input has met before are no mistake, as a time
/// step may have no surface.
class IsovalueCheck
{
public:
  /// \param request of a frame that was made
  /// \param ranges  of its samples; unused if all isovalues are transparent
  /// \return what is wrong and what to do about it; empty if there is no warning
  std::string Check(
    const DrawnVolume& drawn, const FrameRequest& request, const ValueRangePyramid& ranges);

private:
  /// What is known of a volume.
  struct Story
  {
    vtkWeakPointer<vtkVolume> Of;
    bool IsTold = false;
    std::vector<double> Met; ///< the last isovalues of which a sample could meet some
    vtkWeakPointer<vtkDataObject> MetBy;
    std::vector<double> Transparent; ///< the last isovalues that were all transparent
    vtkWeakPointer<vtkDataObject> TransparentIn;
  };

  std::string Check(const DrawnVolume& drawn, const std::vector<double>& isovalues,
    SurfaceMode mode, const ValueRangePyramid& ranges);
  std::string CheckTransparent(const DrawnVolume& drawn, const FrameRequest& request);

  Story& StoryOf(vtkVolume* volume);

  std::vector<Story> Stories;
};

}

#endif
