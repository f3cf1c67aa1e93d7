// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Meddler_h
#define Testing_Meddler_h

#include <vtkCommand.h>
#include <vtkObject.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <utility>

/// Calls a function at an event, once, and checks that progress rises.
class Meddler
{
public:
  /// \param report how many events pass before
  Meddler(vtkObject* object, unsigned long event, int report, std::function<void()> act)
    : Of(object)
    , Left(report)
    , Act(std::move(act))
    , Tag(object->AddObserver(event, this, &Meddler::Hear))
  {
  }
  ~Meddler() { this->Of->RemoveObserver(this->Tag); }
  Meddler(const Meddler&) = delete;
  Meddler& operator=(const Meddler&) = delete;

  bool IsRising = true, IsDone = false;

private:
  void Hear(vtkObject*, unsigned long event, void* data)
  {
    const bool isProgress =
      event == vtkCommand::ProgressEvent || event == vtkCommand::VolumeMapperRenderProgressEvent;
    if (isProgress && data)
    {
      const double now = *static_cast<double*>(data);
      this->IsRising = this->IsRising && now >= this->Before && now <= 1.0;
      this->Before = now;
    }
    if (this->Left-- == 0)
    {
      this->IsDone = true;
      this->Act();
    }
  }

  vtkSmartPointer<vtkObject> Of;
  int Left;
  double Before = 0.0;
  std::function<void()> Act;
  unsigned long Tag;
};

#endif
