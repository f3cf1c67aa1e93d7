// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Theme_h
#define Theme_h

// The one place where the window's colours and sizes are chosen.
struct Color
{
  unsigned char Red = 0;
  unsigned char Green = 0;
  unsigned char Blue = 0;
};

namespace Theme
{

constexpr Color View = { 16, 18, 22 };   // behind the volume
constexpr Color Ground = { 24, 27, 32 }; // of panels
constexpr Color Raised = { 36, 40, 47 }; // rows and buttons under the pointer's reach
constexpr Color Line = { 46, 51, 60 };   // between parts
constexpr Color Text = { 222, 226, 232 };
constexpr Color Quiet = { 138, 146, 158 }; // labels, keys
constexpr Color Faint = { 84, 92, 104 };   // bars below the isovalue
constexpr Color Accent = { 92, 172, 238 }; // what is on or held
constexpr Color Hit = { 84, 184, 148 };
constexpr Color Possible = { 236, 196, 72 }; // the yellow of ColorByAnswer
constexpr Color Miss = { 66, 78, 98 };
constexpr Color Warning = { 240, 128, 96 };

constexpr int SmallText = 12;
constexpr int NormalText = 13;
constexpr int LargeText = 17;
constexpr int Margin = 14;

}

#endif
