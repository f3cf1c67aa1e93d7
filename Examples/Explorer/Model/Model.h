// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Model_h
#define Model_h

#include "Files/VolumeReader.h"
#include "Model/Session.h"
#include "Model/VolumeView.h"
#include "View/Histogram.h"

#include <array>
#include <functional>
#include <string>

// What is shown, and what can be done with it. It knows nothing of windows and panels.
class Model
{
public:
  // Is told what is going on and how far it is; false stops it.
  using Progress = std::function<bool(const std::string& what, double share)>;

  // from: the viewer's place at first ("+y"; empty: what suits the file); up: the way up.
  Model(const std::string& from, const std::string& up);

  void SetProgress(const Progress& progress) { this->Report = progress; }

  // Throws UserError; what was shown stays then.
  void Open(const Session& session);

  const Session& State() const { return this->Current; }
  const Histogram& Counted() const { return this->Samples; }
  double Isovalue() const { return *this->Current.Isovalue; }
  const std::string& Name() const { return this->Shown.Name; }
  std::string Description() const; // "256 x 256 x 110 uchar"

  // The next array of the file; another time step. The view stays. Both throw UserError.
  void TurnArray();
  void TurnTimeStep(int steps);

  // The nearest isovalue there is in the data.
  void SetIsovalue(double isovalue);
  void StepIsovalue(double steps); // of 1/256 of the range

  // False if a choice has no effect on what is shown: for meshes, of other data.
  bool Offers(const Choice& choice) const { return this->IsMesh || !choice.IsForMeshes; }

  // The next value of a choice, or the one before; the first follows the last.
  void Turn(Choose what, int steps);

  void ResetView();
  void Save(const std::string& path); // a session; throws UserError
  bool BuildIsomap();

  // Whether the choices say so and it was neither built nor stopped in this view.
  bool WantsIsomapAhead();

  VolumeView View;

private:
  Volume Read(const VolumeSource& source);
  void Show(Volume volume, Histogram samples, const Session& session);

  // What an isomap belongs to, of one volume.
  struct Sight
  {
    CameraState Camera;
    std::array<int, 3> Picture = { 0, 0, 0 }; // its size and the surface mode

    bool operator==(const Sight& other) const
    {
      return this->Camera == other.Camera && this->Picture == other.Picture;
    }
  };
  Sight PresentSight();

  std::string From;
  std::string Up;
  Progress Report;
  Session Current;
  Volume Shown;
  Histogram Samples;
  bool IsMesh = false; // Shown

  Sight Ahead; // whose isomap was built, or stopped
};

#endif
