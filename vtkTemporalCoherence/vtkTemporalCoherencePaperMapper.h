// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherencePaperMapper
 * @brief   settings for a comparison with the paper
 *
 * This is a base class of vtkTemporalCoherenceVolumeMapper. Its settings choose between the
 * published method ("Accelerating Volume Visualization by Exploiting Temporal Coherence") and the
 * method of this library. Applications need none of them.
 *
 * @sa vtkTemporalCoherenceVolumeMapper
 */

#ifndef vtkTemporalCoherencePaperMapper_h
#define vtkTemporalCoherencePaperMapper_h

#include "vtkTemporalCoherenceDropInMapper.h"
#include "vtkTemporalCoherenceModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class VTKTEMPORALCOHERENCE_EXPORT VTK_MARSHALAUTO vtkTemporalCoherencePaperMapper
  : public vtkTemporalCoherenceDropInMapper
{
public:
  vtkAbstractTypeMacro(vtkTemporalCoherencePaperMapper, vtkTemporalCoherenceDropInMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Values of ImageCachePolicy. */
  enum ImageCachePolicies
  {
    LATEST = 0,
    KEY_IMAGE = 1
  };

  //@{
  /**
   * Set/Get which frames the image cache keeps. LATEST (default): every frame. KEY_IMAGE: cold
   * frames only. One is made every KeyImageInterval frames (default: 7; less than 1 is clamped to
   * 1).
   */
  virtual void SetImageCachePolicy(int policy);
  vtkGetMacro(ImageCachePolicy, int);
  void SetImageCachePolicyToLatest() { this->SetImageCachePolicy(LATEST); }
  void SetImageCachePolicyToKeyImage() { this->SetImageCachePolicy(KEY_IMAGE); }
  vtkSetClampMacro(KeyImageInterval, int, 1, VTK_INT_MAX);
  vtkGetMacro(KeyImageInterval, int);
  //@}

  /** Values of ImageCacheShading and IsomapShading. */
  enum Shadings
  {
    RESHADE = 0,
    INTERPOLATE = 1
  };

  //@{
  /**
   * Set/Get how known hits are shaded. RESHADE (default) computes normals and colours from the
   * field. INTERPOLATE is faster, but not exact: ImageCacheShading (for definite hits with PAPER)
   * takes colours from the cached image, IsomapShading takes normals from the isomap's knots.
   */
  virtual void SetImageCacheShading(int shading);
  vtkGetMacro(ImageCacheShading, int);
  void SetImageCacheShadingToReshade() { this->SetImageCacheShading(RESHADE); }
  void SetImageCacheShadingToInterpolate() { this->SetImageCacheShading(INTERPOLATE); }
  virtual void SetIsomapShading(int shading);
  vtkGetMacro(IsomapShading, int);
  void SetIsomapShadingToReshade() { this->SetIsomapShading(RESHADE); }
  void SetIsomapShadingToInterpolate() { this->SetIsomapShading(INTERPOLATE); }
  //@}

  //@{
  /**
   * ColorByAnswer (default: off) paints surfaces yellow if they were found without the image cache.
   * It affects frames of the route ImageCache only. SpaceLeaping (default: on) skips blocks of
   * cells that no isovalue passes. Without it, a ray reads every cell on its way.
   */
  vtkSetMacro(ColorByAnswer, vtkTypeBool);
  vtkGetMacro(ColorByAnswer, vtkTypeBool);
  vtkBooleanMacro(ColorByAnswer, vtkTypeBool);
  vtkSetMacro(SpaceLeaping, vtkTypeBool);
  vtkGetMacro(SpaceLeaping, vtkTypeBool);
  vtkBooleanMacro(SpaceLeaping, vtkTypeBool);
  //@}

protected:
  vtkTemporalCoherencePaperMapper();
  ~vtkTemporalCoherencePaperMapper() override;

private:
  vtkTemporalCoherencePaperMapper(const vtkTemporalCoherencePaperMapper&) = delete;
  void operator=(const vtkTemporalCoherencePaperMapper&) = delete;

  int ImageCachePolicy = LATEST;
  int KeyImageInterval = 7;
  int ImageCacheShading = RESHADE;
  int IsomapShading = RESHADE;
  vtkTypeBool ColorByAnswer = 0;
  vtkTypeBool SpaceLeaping = 1;
};
VTK_ABI_NAMESPACE_END

#endif
