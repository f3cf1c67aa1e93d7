// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Mistake_h
#define Testing_Mistake_h

#include "Checks/Expect.h"
#include "Scenes/Scene.h"

#include <vtkTestErrorObserver.h>

#include <string>

/// Checks the effect of a mistake in a scene: one error that names it, and the last picture stays.
class Mistake
{
public:
  /// Draw the scene, which is still valid.
  /// \param word expected part of the error
  Mistake(Scene& scene, const std::string& word)
    : Of(scene)
    , Word(word)
  {
    this->Of.Mapper->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    Expect(this->Of.Render(Size, Size), word + ": valid before");
    this->Color->DeepCopy(this->Of.Color);
  }

  /// After the mistake: the scene is refused with one error.
  void ExpectRefused(int width = Size, int height = Size)
  {
    Expect(!this->Of.Render(width, height), this->Word + ": refused");
    this->Message = this->Observer->GetErrorMessage();
    Expect(this->Observer->GetError() && this->Message.find(this->Word) != std::string::npos,
      this->Word + ": the message names it, but is: " + this->Message);
    Expect(AreIdentical(this->Color, this->Of.Color), this->Word + ": the images are left alone");
    Expect(this->Of.Mapper->PickPixel(Size / 2, Size / 2, nullptr, nullptr, nullptr),
      this->Word + ": the last picture can still be picked");
    this->Observer->Clear();
    Expect(!this->Of.Render(width, height) && !this->Observer->GetError(),
      this->Word + ": said once only");
  }

  /// After the mistake is undone: the picture is as before.
  void ExpectMended()
  {
    Expect(this->Of.Render(Size, Size) && !this->Observer->GetError(), this->Word + ": mended");
    Expect(AreIdentical(this->Color, this->Of.Color), this->Word + ": the same picture again");
  }

  std::string Message; ///< of the error

private:
  static constexpr int Size = 60;

  Scene& Of;
  std::string Word;
  vtkNew<vtkTest::ErrorObserver> Observer;
  vtkNew<vtkImageData> Color;
};

#endif
