// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_EventCounter_h
#define Testing_EventCounter_h

#include <vtkCommand.h>
#include <vtkObject.h>

/// Counts an event of an object. Errors and warnings that are counted are not printed.
class EventCounter
{
public:
  EventCounter(vtkObject* object, unsigned long event)
    : Observed(object)
    , Tag(object->AddObserver(event, this, &EventCounter::Add))
  {
  }
  ~EventCounter() { this->Observed->RemoveObserver(this->Tag); }
  EventCounter(const EventCounter&) = delete;
  void operator=(const EventCounter&) = delete;

  int Count = 0;

private:
  void Add() { ++this->Count; }

  vtkObject* Observed;
  unsigned long Tag;
};

#endif
