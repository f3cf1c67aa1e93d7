// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TestDriver.h"

#include "ChangedScene.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkObjectFactoryCollection.h>
#include <vtkTestingInteractor.h>
#include <vtkTestingObjectFactory.h>

#include <cstdlib>
#include <string>

namespace
{

/// The argument after an option.
std::string ArgumentOf(const std::string& option, int argc, char* argv[])
{
  for (int i = 1; i + 1 < argc; ++i)
  {
    if (option == argv[i])
    {
      return argv[i + 1];
    }
  }
  return {};
}

/// Make a factory the only one that is asked for a class.
void UseFactory(vtkObjectFactory* factory, const char* className)
{
  vtkObjectFactoryCollection* others = vtkObjectFactory::GetRegisteredFactories();
  others->InitTraversal();
  while (vtkObjectFactory* other = others->GetNextItem())
  {
    other->Disable(className);
  }
  vtkObjectFactory::RegisterFactory(factory);
}

}

int DriveTest(int argc, char* argv[], int (*test)(int, char*[]))
{
  vtkLogger::Init(argc, argv, nullptr);
  vtkTestingInteractor::ValidBaseline = ArgumentOf("-V", argc, argv);
  vtkTestingInteractor::TempDirectory = ArgumentOf("-T", argc, argv);
  vtkTestingInteractor::DataDirectory = ArgumentOf("-D", argc, argv);
  UseFactory(vtkNew<vtkTestingObjectFactory>(), "vtkRenderWindowInteractor");
  if (const char* const change = std::getenv("VTK_TESTS_SCENE"))
  {
    UseFactory(MakeFactoryOfChangedScenes(change), "vtkRenderer");
  }
  return test(argc, argv);
}
