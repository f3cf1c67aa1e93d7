// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef OneTimeStep_h
#define OneTimeStep_h

#include <vtkObjectFactory.h>
#include <vtkXMLDataElement.h>

// One of VTK's readers of XML files, for a file that may hold an array once for each time step.
// Since VTK 9.6 a reader keeps only the first array of a name, whatever time is asked for. So this
// one drops the arrays of other times before that. It reads one time step: make another one for the
// next.
template <typename Reader>
class OneTimeStep : public Reader
{
public:
  static OneTimeStep* New() { VTK_STANDARD_NEW_BODY(OneTimeStep); }

protected:
  void SetupOutputData() override
  {
    // The output has the arrays of the first piece.
    this->LeaveOutOtherTimes(this->PointDataElements ? this->PointDataElements[0] : nullptr);
    this->LeaveOutOtherTimes(this->CellDataElements ? this->CellDataElements[0] : nullptr);
    Reader::SetupOutputData();
  }

private:
  void LeaveOutOtherTimes(vtkXMLDataElement* arrays)
  {
    for (int i = arrays ? arrays->GetNumberOfNestedElements() : 0; i-- > 0;)
    {
      vtkXMLDataElement* array = arrays->GetNestedElement(i);
      const int count =
        array->GetVectorAttribute("TimeStep", this->NumberOfTimeSteps, this->TimeSteps);
      if (count > 0 && !this->IsTimeStepInArray(this->CurrentTimeStep, this->TimeSteps, count))
      {
        arrays->RemoveNestedElement(array);
      }
    }
  }
};

#endif
