// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fuzz_Inputs_h
#define Fuzz_Inputs_h

#include "World/World.h"

namespace Fuzz
{

/// Data objects that a mapper may be given, right ones and wrong ones.
namespace Inputs
{

/// An image with samples on points or cells.
vtkSmartPointer<vtkImageData> MakeImage(World& world);

/// An image of a few labels from 0 on, with another array beside them.
vtkSmartPointer<vtkDataObject> MakeLabels(World& world);

/// A rectilinear grid, whose coordinates may be in disorder.
vtkSmartPointer<vtkDataObject> MakeGrid(World& world);

/// Blocks that fit each other, or do not.
vtkSmartPointer<vtkDataObject> MakeBlocks(World& world);

/// A mesh of some kind of cells, a curvilinear or adaptive grid, or blocks of meshes.
vtkSmartPointer<vtkDataObject> MakeMesh(World& world);

/// An image, a grid or blocks; rarely null or what cannot be drawn.
vtkSmartPointer<vtkDataObject> MakeAny(World& world);

/// Give the mapper an input, through a pipeline or not.
void Show(World& world, vtkDataObject* data);

}

}

#endif
