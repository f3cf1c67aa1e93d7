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

/// Who draws what, and for whom.
struct DrawnVolume
{
  vtkVolumeMapper* Mapper;
  vtkVolume* Volume;
  vtkRenderer* Renderer;
};

/// True if a mapper may not know all the data that its isovalues are meant for: its input is a
/// piece of a pipeline's data or one block of several, or several volumes share the property.
/// Looks into ghost arrays, which takes a while.
bool MaySeePartOnly(const DrawnVolume& drawn);

/// Tells of isovalues that no sample can meet, and of VTK's untouched 0 where it is transparent: a
/// picture that is empty for another reason than its user thinks. It tells once for each volume,
/// and once more only after some isovalue was met. Isovalues that were met by this input before are
/// no mistake, whatever its samples are now: a time step may have no surface.
class IsovalueCheck
{
public:
  /// \param request of a frame that was made
  /// \param ranges  of its samples; not looked at if all isovalues are transparent
  /// \return what is wrong and what to do about it; empty if there is nothing to tell
  std::string Check(
    const DrawnVolume& drawn, const FrameRequest& request, const ValueRangePyramid& ranges);

private:
  /// What is known of a volume.
  struct Story
  {
    vtkWeakPointer<vtkVolume> Of;
    bool IsTold = false;
    std::vector<double> Met; ///< the last isovalues some of which a sample could meet
    vtkWeakPointer<vtkDataObject> MetBy;
    std::vector<double> Transparent; ///< the last isovalues none of which has an opacity
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
