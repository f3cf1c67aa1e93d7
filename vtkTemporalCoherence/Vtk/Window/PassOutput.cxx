// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/PassOutput.h"

#include "Window/FindPass.h"

#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLCamera.h>
#include <vtkRenderer.h>
#include <vtkSSAOPass.h>
#include <vtkShaderProgram.h>
#include <vtkShadowMapBakerPass.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>

namespace TemporalCoherence
{

PassOutput OutputFor(vtkVolume* volume)
{
  if (FindPass<vtkShadowMapBakerPass>(volume))
  {
    return PassOutput::Shadow;
  }
  return FindPass<vtkSSAOPass>(volume) ? PassOutput::Occluder : PassOutput::Color;
}

std::string DeclarationsOf(PassOutput output)
{
  const std::string position = "uniform mat4 viewFromClip;\n"
                               "uniform vec2 firstClip;\n"
                               "uniform vec2 sizeClip;\n";
  switch (output)
  {
    case PassOutput::Occluder:
      return position +
        "uniform mat4 viewFromWorld;\n"
        "uniform sampler2D normalTexture;\n";
    case PassOutput::Shadow:
      return position +
        "uniform float depthC;\n"
        "uniform float nearZ;\n"
        "uniform float farZ;\n";
    default:
      return "";
  }
}

std::string StatementsOf(PassOutput output)
{
  const std::string position =
    "vec4 place = viewFromClip * vec4(firstClip + texCoord * sizeClip, 2.0 * depth - 1.0, 1.0);\n"
    "place /= place.w;\n";
  switch (output)
  {
    case PassOutput::Occluder:
      return position +
        "vec3 normal = mat3(viewFromWorld) * texture(normalTexture, texCoord).xyz;\n"
        "gl_FragData[0] = color;\n"
        "gl_FragData[1] = vec4(place.xyz, 1.0);\n"
        "gl_FragData[2] = vec4(normalize(normal), 1.0);\n";
    case PassOutput::Shadow:
      return position +
        "float distanceShare = (-place.z - nearZ) / (farZ - nearZ);\n"
        "gl_FragData[0] = vec4(exp(depthC * distanceShare), 0.0, 0.0, 1.0);\n";
    default:
      return "gl_FragData[0] = color;\n";
  }
}

void SetUniforms(PassOutput output, vtkShaderProgram* program, vtkRenderer* renderer,
  vtkVolume* volume, const glm::vec2& first, const glm::vec2& size)
{
  auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
  if (output == PassOutput::Color || !camera)
  {
    return;
  }
  // These are already transposed, as OpenGL needs them.
  vtkMatrix4x4 *worldToView, *viewToClip, *worldToClip;
  vtkMatrix3x3* normals;
  camera->GetKeyMatrices(renderer, worldToView, normals, viewToClip, worldToClip);
  vtkNew<vtkMatrix4x4> clipToView;
  vtkMatrix4x4::Invert(viewToClip, clipToView);
  const glm::vec2 firstClip = 2.0f * first - 1.0f, sizeClip = 2.0f * size;
  program->SetUniformMatrix("viewFromClip", clipToView);
  program->SetUniform2f("firstClip", &firstClip.x);
  program->SetUniform2f("sizeClip", &sizeClip.x);
  if (output == PassOutput::Occluder)
  {
    program->SetUniformMatrix("viewFromWorld", worldToView);
  }
  else
  {
    vtkOpenGLRenderPass* pass = FindPass<vtkShadowMapBakerPass>(volume);
    pass->SetShaderParameters(program, volume->GetMapper(), volume, nullptr);
  }
}

}
