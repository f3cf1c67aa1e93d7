# What has to be changed in VTK's example Medical4 (Examples/Medical/Cxx/Medical4.cxx, Copyright (c)
# Ken Martin, Will Schroeder, Bill Lorensen, BSD-3-Clause) to draw with this mapper.
/#include <vtkColorTransferFunction.h>/a\
#include <vtkContourValues.h>
s/vtkFixedPointVolumeRayCastMapper/vtkTemporalCoherenceVolumeMapper/
/volumeProperty->SetColor(volumeColor);/i\
  volumeProperty->GetIsoSurfaceValues()->SetValue(0, 500);\
  volumeProperty->GetIsoSurfaceValues()->SetValue(1, 1150);
