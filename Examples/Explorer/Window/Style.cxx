// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/Style.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkStringArray.h>

#include <cctype>

vtkStandardNewMacro(Style);

int Style::X() const
{
  return this->Interactor->GetEventPosition()[0];
}

int Style::Y() const
{
  return this->Interactor->GetRenderWindow()->GetSize()[1] - 1 -
    this->Interactor->GetEventPosition()[1];
}

bool Style::IsTaken(bool isRight)
{
  if (this->By->IsBusy())
  {
    return true;
  }
  this->IsPressed = true;
  this->LastX = this->X();
  this->LastY = this->Y();
  const Hands::Grip grip = this->By->Press(this->X(), this->Y(), isRight);
  // What the press began may have taken long: the button may be up again.
  this->Grip = this->IsPressed ? grip : Hands::Grip::None;
  return grip != Hands::Grip::None;
}

void Style::OnMouseMove()
{
  // An event may come again for the same place.
  const bool isNew = this->X() != this->LastX || this->Y() != this->LastY;
  this->LastX = this->X();
  this->LastY = this->Y();
  if (this->By->IsBusy() || !isNew)
  {
    return;
  }
  if (this->Grip == Hands::Grip::Held)
  {
    this->By->Drag(this->X(), this->Y());
  }
  else if (this->Grip == Hands::Grip::None)
  {
    this->Superclass::OnMouseMove();
  }
}

void Style::OnLeftButtonDown()
{
  if (!this->IsTaken(false))
  {
    this->Superclass::OnLeftButtonDown();
  }
}

void Style::OnLeftButtonUp()
{
  this->IsPressed = false;
  this->Grip = Hands::Grip::None;
  this->Superclass::OnLeftButtonUp();
}

void Style::OnRightButtonDown()
{
  if (!this->IsTaken(true))
  {
    this->Superclass::OnRightButtonDown();
  }
}

void Style::OnRightButtonUp()
{
  this->IsPressed = false;
  this->Grip = Hands::Grip::None;
  this->Superclass::OnRightButtonUp();
}

void Style::OnMiddleButtonDown()
{
  if (!this->By->IsBusy())
  {
    this->Superclass::OnMiddleButtonDown();
  }
}

void Style::OnMouseWheelForward()
{
  if (!this->By->IsBusy() && !this->By->Wheel(this->X(), this->Y(), 1))
  {
    this->Superclass::OnMouseWheelForward();
  }
}

void Style::OnMouseWheelBackward()
{
  if (!this->By->IsBusy() && !this->By->Wheel(this->X(), this->Y(), -1))
  {
    this->Superclass::OnMouseWheelBackward();
  }
}

void Style::OnKeyPress()
{
  const char* sym = this->Interactor->GetKeySym();
  const std::string name = sym ? sym : "";
  const bool hasShift = this->Interactor->GetShiftKey() != 0;
  // Since VTK 9.3, X11 windows tell the key and not the character: "s" for "S", and "/", on many
  // keyboards, for "?".
  char character = this->Interactor->GetKeyCode();
  if (hasShift)
  {
    character = static_cast<char>(std::toupper(static_cast<unsigned char>(character)));
  }
  if (name == "F1" || name == "slash")
  {
    character = '?';
  }
  this->By->Key(name, character, hasShift);
}

void Style::OnDropFiles(vtkStringArray* paths)
{
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < paths->GetNumberOfValues(); ++i)
  {
    names.push_back(paths->GetValue(i));
  }
  if (!this->By->IsBusy())
  {
    this->By->Drop(names);
  }
}
