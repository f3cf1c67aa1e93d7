// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Growth.h"

#include "Measuring.h"
#include "Volumes.h"

#include <cstddef>
#include <iostream>

namespace Growth
{
namespace
{

/// Where growth begins, samples a side.
constexpr int Smallest = 128;

MarkdownTable BeginTable(const std::vector<Quantity>& quantities)
{
  std::vector<std::string> head = { "object", "samples" };
  for (const Quantity& quantity : quantities)
  {
    if (!quantity.Column.empty())
    {
      head.insert(head.end(), { quantity.Column, "growth" });
    }
  }
  return MarkdownTable(head);
}

}

void Report(const std::vector<Quantity>& quantities, int pixels, int largest,
  const std::function<std::vector<double>(Stage&)>& measure, JsonWriter& json)
{
  if (largest < Smallest)
  {
    throw Measuring::Failure("Give --largest a number of at least " + Plain(Smallest) + ".");
  }
  std::cout << "medians in ms, and by what a doubling multiplies\n\n";
  const MarkdownTable table = BeginTable(quantities);
  json.OpenList("growth");
  for (const Volumes::Sample& object :
    { Volumes::Sample{ "spheres", 100 }, Volumes::Sample{ "marschner-lobb", 128 } })
  {
    std::vector<double> last;
    for (int n = Smallest; n <= largest; n *= 2)
    {
      Stage stage(Volumes::Load(object.Name + std::to_string(n)), object.Isovalue, pixels);
      const std::vector<double> now = measure(stage);
      std::vector<std::string> cells = { object.Name, Plain(n) + "^3" };
      json.OpenObject();
      json.Add("object", object.Name);
      json.Add("samplesASide", n);
      for (std::size_t i = 0; i < quantities.size(); ++i)
      {
        json.Add(quantities[i].Name, now[i]);
        if (!quantities[i].Column.empty())
        {
          cells.push_back(Fixed(now[i], 1));
          cells.push_back(last.empty() ? "-" : Fixed(Measuring::Ratio(now[i], last[i]), 2));
        }
      }
      json.Close();
      table.Row(cells);
      last = now;
    }
  }
  json.Close();
  std::cout << '\n';
}

}
