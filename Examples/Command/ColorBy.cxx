// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorBy.h"

#include "Files/Arrays.h"
#include "Program/CommandLine.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"

#include <algorithm>

namespace
{

[[noreturn]] void RefuseName(const Model& model, const std::string& name)
{
  std::string others;
  for (const ColorArrays::Item& item : model.View.Colors.Arrays().All())
  {
    others += (others.empty() ? "" : ", ") + item.Choice.Name;
  }
  const std::vector<ArrayChoice> all = AllArrays(model.Data().Data);
  const bool isInSome = std::any_of(
    all.begin(), all.end(), [&name](const ArrayChoice& choice) { return choice.Name == name; });
  throw UserError(
    (isInSome ? "Not all parts of " + Quoted(model.Data().Name) + " have the array " + Quoted(name)
              : Quoted(model.Data().Name) + " has no array " + Quoted(name) + " to colour by") +
    (others.empty() ? "; leave out --color-by."
                    : "; choose one of those it has: " + Shortened(Printable(others)) + "."));
}

}

ArrayColor ColorByOf(const Model& model, const std::string& text)
{
  if (!model.DrawsSurfaces())
  {
    throw UserError("Arrays colour surfaces and labels, of which none are drawn; leave out "
                    "--color-by, or choose --draw surfaces.");
  }
  const ColorArrays& arrays = model.View.Colors.Arrays();
  if (arrays.Find(text)) // a name may have a colon
  {
    return model.View.Colors.Fitted({ text, -1 });
  }
  const std::size_t colon = text.rfind(':');
  const std::string name = text.substr(0, colon);
  const std::string part = colon == std::string::npos ? "" : text.substr(colon + 1);
  const ColorArrays::Item* const array = arrays.Find(name);
  if (!array)
  {
    RefuseName(model, text);
  }
  double number = 0.0;
  const bool isNumber = IsNumber(part, number);
  const int component = isNumber && number <= array->Components ? static_cast<int>(number) : 0;
  if (part != "length" && (component < 1 || component != number))
  {
    throw UserError("--color-by takes a component from 1 to " + std::to_string(array->Components) +
      " of " + Quoted(name) + ", or length, not " + Quoted(part) + ".");
  }
  return model.View.Colors.Fitted({ name, component - 1 });
}
