# What has to be changed in VTK's example Medical1 (Examples/Medical/Cxx/Medical1.cxx, Copyright (c)
# Ken Martin, Will Schroeder, Bill Lorensen, BSD-3-Clause) to draw with this mapper: what makes
# polygons goes, and the actor becomes a volume in the actor's colours.
/#include <vtkContourFilter.h>/c\
#include <vtkColorTransferFunction.h>\
#include <vtkContourValues.h>
/#include <vtkPolyDataNormals.h>/d
/#include <vtkSmartPointer.h>/a\
#include <vtkTemporalCoherenceVolumeMapper.h>\
#include <vtkVolume.h>
/#include <vtkVolume16Reader.h>/a\
#include <vtkVolumeProperty.h>
/vtkSmartPointer<vtkContourFilter> skinExtractor/,/skinMapper->ScalarVisibilityOff/c\
  vtkSmartPointer<vtkTemporalCoherenceVolumeMapper> skinMapper =\
    vtkSmartPointer<vtkTemporalCoherenceVolumeMapper>::New();\
  skinMapper->SetInputConnection(v16->GetOutputPort());
s/vtkActor> skin = vtkSmartPointer<vtkActor>/vtkVolume> skin = vtkSmartPointer<vtkVolume>/
/skin->SetMapper(skinMapper);/a\
  skin->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 500);\
  skin->GetProperty()->GetRGBTransferFunction()->AddRGBPoint(500, 1, 1, 1);\
  skin->GetProperty()->SetInterpolationTypeToLinear();\
  skin->GetProperty()->ShadeOn();\
  skin->GetProperty()->SetAmbient(0);\
  skin->GetProperty()->SetDiffuse(1);\
  skin->GetProperty()->SetSpecular(0);
