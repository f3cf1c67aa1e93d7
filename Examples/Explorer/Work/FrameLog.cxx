// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Work/FrameLog.h"

#include "Model/VolumeView.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"

FrameLog::FrameLog(const std::string& path)
{
  if (path.empty())
  {
    return;
  }
  this->File.open(path);
  if (!this->File)
  {
    throw UserError(Quoted(path) + " cannot be written; name another file with --log.");
  }
}

void FrameLog::Frame(const FrameFacts& facts, double isovalue, double windowMs)
{
  this->File << "frame " << ++this->Frames << " route " << facts.Route << " isovalue " << isovalue
             << " ms " << windowMs << " mapper " << facts.Ms << " traced " << facts.Traced
             << " isomap " << facts.IsomapMiB << std::endl;
}

void FrameLog::Said(const std::string& sentence)
{
  this->Event("said", sentence);
}

void FrameLog::Place(const std::string& name, int x, int y)
{
  this->File << "place " << Printable(name) << ' ' << x << ' ' << y << std::endl;
}

void FrameLog::Event(const std::string& name, const std::string& value)
{
  this->File << name << ' ' << Printable(value) << std::endl;
}
