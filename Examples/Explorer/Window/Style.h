// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Style_h
#define Style_h

#include <vtkInteractorStyleTrackballCamera.h>

#include <string>
#include <vector>

// What is done by hand. Places are pixels from the window's upper left corner.
class Hands
{
public:
  virtual ~Hands() = default;

  // While something takes long, only keys are passed on.
  virtual bool IsBusy() const = 0;

  enum class Grip
  {
    None, // the view's: the camera turns
    Done, // nothing more to do until the button is released
    Held, // Drag() is called until the button is released
  };
  virtual Grip Press(int x, int y, bool isRight) = 0;
  virtual void Drag(int x, int y) = 0;
  virtual bool Wheel(int x, int y, int turns) = 0; // false: the view's

  // name: X's; character: 0 if the key has none.
  virtual void Key(const std::string& name, char character, bool hasShift) = 0;
  virtual void Drop(const std::vector<std::string>& paths) = 0;
};

// The trackball camera where hands do not hold anything else. None of VTK's own keys.
class Style : public vtkInteractorStyleTrackballCamera
{
public:
  static Style* New();
  vtkTypeMacro(Style, vtkInteractorStyleTrackballCamera);

  void SetHands(Hands* hands) { this->By = hands; }

  void OnMouseMove() override;
  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnRightButtonDown() override;
  void OnRightButtonUp() override;
  void OnMiddleButtonDown() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void OnLeftButtonDoubleClick() override { this->OnLeftButtonDown(); }
  void OnRightButtonDoubleClick() override { this->OnRightButtonDown(); }
  void OnKeyPress() override;
  void OnChar() override {}
  void OnDropFiles(vtkStringArray* paths) override;

protected:
  Style() = default;

private:
  bool IsTaken(bool isRight);
  int X() const;
  int Y() const;

  Hands* By = nullptr;
  Hands::Grip Grip = Hands::Grip::None;
  bool IsPressed = false;
  int LastX = -1;
  int LastY = -1;
};

#endif
