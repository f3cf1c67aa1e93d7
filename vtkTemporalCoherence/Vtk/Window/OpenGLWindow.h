// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_OpenGLWindow_h
#define TemporalCoherence_OpenGLWindow_h

#include "Scene/Tiles.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkRenderWindow;
class vtkTextureObject;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Enumerants of OpenGL. They are named here because their header differs between versions of VTK.
namespace Gl
{
constexpr unsigned int One = 1;
constexpr unsigned int LessOrEqual = 0x0203;
constexpr unsigned int OneMinusSourceAlpha = 0x0303;
constexpr unsigned int CullFace = 0x0B44;
constexpr unsigned int DepthTest = 0x0B71;
constexpr unsigned int Viewport = 0x0BA2;
constexpr unsigned int Blend = 0x0BE2;
constexpr unsigned int ScissorTest = 0x0C11;
constexpr unsigned int MaxTextureSize = 0x0D33;
constexpr unsigned int Float = 0x1406;
constexpr unsigned int DepthComponent = 0x1902;
constexpr unsigned int Rgba8 = 0x8058;
constexpr unsigned int Rgba16 = 0x805B;
constexpr unsigned int Samples = 0x80A9;
constexpr unsigned int ReadFramebuffer = 0x8CA8;
constexpr unsigned char True = 1;
constexpr unsigned char False = 0;
}

/// The present viewport in the window.
PixelRect ViewportOf(vtkOpenGLRenderWindow* window);

/// True if an OpenGL renderer with this name runs on the CPU.
bool IsSoftwareRenderer(const std::string& name);

/// True if the OpenGL of a window, whose context is current, runs on the CPU. Takes a while.
bool HasSoftwareOpenGL(vtkRenderWindow* window);

/// Prepare a texture of a window, with nearest filtering.
void PrepareTexture(vtkTextureObject* texture, vtkOpenGLRenderWindow* window);

}

#endif
