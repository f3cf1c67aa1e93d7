// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ViewMutator_h
#define TemporalCoherence_ViewMutator_h

#include "FileParts.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// Makes random changes in view files, at three levels: bytes of the file; its header, with a right
/// checksum; and unpacked sections, which are packed again.
class ViewMutator
{
public:
  using Bytes = std::vector<std::uint8_t>;
  using Json = nlohmann::json;

  explicit ViewMutator(const Bytes& good)
    : Good(good)
    , GoodParts(good)
    , GoodHeader(Json::parse(this->GoodParts.Header))
  {
  }

  /// The change of that number.
  Bytes Make(unsigned number)
  {
    this->Random.seed(number);
    switch (number % 4)
    {
      case 0:
        return this->Changed(this->Good);
      case 1:
        return this->WithChangedText();
      case 2:
        return this->WithChangedValues();
      default:
        return this->WithChangedSection();
    }
  }

private:
  std::size_t Below(std::size_t count)
  {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(this->Random);
  }

  /// Change, insert, repeat or delete some bytes, or cut them off.
  template <typename Text>
  Text Changed(Text text)
  {
    for (std::size_t changes = 1 + this->Below(3); changes > 0 && !text.empty(); --changes)
    {
      const auto at = text.begin() + static_cast<std::ptrdiff_t>(this->Below(text.size()));
      const auto left = static_cast<std::size_t>(text.end() - at);
      const auto some = at + static_cast<std::ptrdiff_t>(std::min(this->Below(9), left));
      switch (this->Below(8))
      {
        case 0:
          text.erase(at, some);
          break;
        case 1:
        {
          const Text part(at, some);
          text.insert(text.begin() + static_cast<std::ptrdiff_t>(this->Below(text.size())),
            part.begin(), part.end());
          break;
        }
        case 2:
          text.resize(
            this->Below(4) == 0 ? static_cast<std::size_t>(at - text.begin()) : text.size());
          break;
        case 3:
          *at = static_cast<typename Text::value_type>(*at + 1);
          break;
        case 4:
          *at = static_cast<typename Text::value_type>(*at - 1);
          break;
        default:
          *at = static_cast<typename Text::value_type>(this->Below(256));
      }
    }
    return text;
  }

  Bytes WithChangedText()
  {
    FileParts parts = this->GoodParts;
    const std::size_t digit =
      parts.Header.find_first_of("0123456789-.", this->Below(parts.Header.size()));
    if (this->Below(2) == 0 && digit != std::string::npos)
    {
      parts.Header[digit] = "0123456789-.e"[this->Below(13)];
    }
    else
    {
      parts.Header = this->Changed(parts.Header);
    }
    return parts.Join();
  }

  /// Replace or remove some values anywhere in the header.
  Bytes WithChangedValues()
  {
    const Json values[] = { nullptr, true, "rising", Json::array(), Json::object(), -1, 0, 1, 2, 3,
      7, 16, 24, 127, 255, 384, 65535, 65536, 4294967295u, 1e-300, 1e300, -0.5, 9223372036854775807,
      18446744073709551615u, "\xc3\xa4", { 1, 2 }, { 0, 0, 0 }, { { "x", 1 } } };
    FileParts parts = this->GoodParts;
    Json header = this->GoodHeader;
    for (std::size_t changes = 1 + this->Below(3); changes > 0; --changes)
    {
      Json* parent = &header;
      Json* at = &header;
      while (at->is_structured() && !at->empty() && (at == &header || this->Below(8) != 0))
      {
        parent = at;
        at = &*std::next(at->begin(), static_cast<std::ptrdiff_t>(this->Below(at->size())));
      }
      const bool isNumber = at->is_number();
      switch (this->Below(6))
      {
        case 0:
          *at = isNumber ? Json(at->get<double>() + 1.0) : values[this->Below(std::size(values))];
          break;
        case 1:
          *at = isNumber ? Json(at->get<double>() * 0.5) : values[this->Below(std::size(values))];
          break;
        case 2:
          if (parent->is_array())
          {
            parent->push_back(Json(*at));
          }
          break;
        case 3:
          if (parent->is_structured() && !parent->empty())
          {
            parent->erase(
              std::next(parent->begin(), static_cast<std::ptrdiff_t>(this->Below(parent->size()))));
          }
          break;
        default:
          *at = values[this->Below(std::size(values))];
      }
    }
    parts.Header = header.dump();
    return parts.Join();
  }

  /// Change a section's unpacked bytes. It moves to the end of the file.
  Bytes WithChangedSection()
  {
    FileParts parts = this->GoodParts;
    Json header = this->GoodHeader;
    Json& views = header["views"];
    Json& view = views[this->Below(views.size())];
    std::vector<Json*> sections;
    for (Json& chunk : view["chunks"])
    {
      sections.insert(sections.end(), 3, &chunk);
    }
    for (const char* name : { "entries", "unknown" })
    {
      if (view.contains(name))
      {
        sections.push_back(&view[name]);
      }
    }
    Json& section = *sections[this->Below(sections.size())];
    Bytes bytes;
    Inflate(parts.Sections.data() + section["offset"].get<std::size_t>(),
      section["bytes"].get<std::size_t>(), section["unpacked"].get<std::size_t>(), bytes);
    bytes = this->Changed(bytes);
    if (section.contains("knots") && this->Below(8) == 0)
    {
      // So that the check of the sum does not stop it.
      const int more = static_cast<int>(this->Below(3)) - 1;
      section["knots"] = section["knots"].get<int>() + more;
      Json& all = view["knots"][section["direction"].get<std::string>()];
      all = all.get<int>() + more;
    }
    const Bytes packed = Deflate(bytes);
    section["offset"] = parts.Sections.size();
    section["bytes"] = packed.size();
    section["unpacked"] = bytes.size();
    parts.Sections.insert(parts.Sections.end(), packed.begin(), packed.end());
    parts.Header = header.dump();
    return parts.Join();
  }

  Bytes Good;
  FileParts GoodParts;
  Json GoodHeader;
  std::mt19937 Random;
};

}

#endif
