// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Sharing.h"

#include "Files/Reading.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"

#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkTemporalCoherenceViewWriter.h>

#include <sstream>

namespace
{

// Hears a writer: passes its progress on, stops it by the answer, and keeps its first error.
class Hearer
{
public:
  Hearer(vtkTemporalCoherenceViewWriter* writer, const Progress& progress)
    : Writer(writer)
    , Report(progress)
  {
    writer->AddObserver(vtkCommand::ProgressEvent, this, &Hearer::OnProgress);
    writer->AddObserver(vtkCommand::ErrorEvent, this, &Hearer::OnError);
  }

  std::string Error;

private:
  void OnProgress(vtkObject*, unsigned long, void* share)
  {
    if (!this->Report(*static_cast<double*>(share)))
    {
      this->Writer->AbortExecuteOn();
    }
  }

  // What follows the name of the class and its address.
  void OnError(vtkObject*, unsigned long, void* text)
  {
    const std::string said = static_cast<const char*>(text);
    const std::string before = "): ";
    const std::size_t at = said.find(before);
    const std::string error = at == std::string::npos ? said : said.substr(at + before.size());
    if (this->Error.empty())
    {
      this->Error = error.substr(0, error.find('\n'));
    }
  }

  vtkTemporalCoherenceViewWriter* Writer;
  const Progress& Report;
};

std::string Written(vtkTemporalCoherenceViewWriter* writer, const SharedView& wanted)
{
  constexpr double megabyte = 1e6;
  std::ostringstream text;
  text.precision(3);
  const double* const range = writer->GetWrittenRange();
  text << "Shared: " << Printable(wanted.Path) << ", "
       << static_cast<double>(writer->GetBytesWritten()) / megabyte << " MB, isovalues " << range[0]
       << " to " << range[1] << (EndsWith(wanted.Path, ".html") ? "; open it with a browser" : "");
  return text.str();
}

}

std::string ShareView(VolumeView& view, const SharedView& wanted, const Progress& progress)
{
  vtkNew<vtkTemporalCoherenceViewWriter> writer;
  writer->SetTitle(wanted.Title.c_str());
  writer->SetCaption(wanted.Caption.c_str());
  writer->SetCitation(wanted.Citation.c_str());
  writer->SetUnits(wanted.Units.c_str());
  writer->SetTolerance(wanted.Tolerance);
  writer->SetSize(wanted.Width, wanted.Height);
  if (wanted.Range)
  {
    writer->SetRange((*wanted.Range)[0], (*wanted.Range)[1]);
  }
  view.Renderer->ResetCameraClippingRange();
  if (wanted.Views > 1)
  {
    writer->AddOrbit(wanted.Views, view.Renderer);
  }
  Hearer hearer(writer, progress);
  if (!writer->WriteView(wanted.Path.c_str(), view.Renderer, view.Actor))
  {
    throw UserError(hearer.Error.empty() ? "It was stopped, and is not saved." : hearer.Error);
  }
  return Written(writer, wanted);
}
