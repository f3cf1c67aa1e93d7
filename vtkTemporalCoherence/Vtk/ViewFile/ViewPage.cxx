// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewFile/ViewPage.h"

#include "ViewPageParts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string_view>

namespace TemporalCoherence
{
namespace
{

using Bytes = std::vector<std::uint8_t>;

constexpr std::string_view Alphabet =
  "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::string_view BeginOfFile = "id=\"view-file\">";

/// Append bytes as Base64.
void AppendBase64(const Bytes& bytes, Bytes& text)
{
  text.reserve(text.size() + (bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3)
  {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t group = 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      group = group << 8 | (i < count ? bytes[at + i] : 0u);
    }
    for (std::size_t i = 0; i < 4; ++i)
    {
      const char digit = Alphabet[group >> (18 - 6 * i) & 63u];
      text.push_back(static_cast<std::uint8_t>(i <= count ? digit : '='));
    }
  }
}

/// \return false if it is no Base64
bool ReadBase64(std::string_view text, Bytes& bytes)
{
  constexpr std::uint8_t none = 64;
  std::array<std::uint8_t, 256> values;
  values.fill(none);
  for (std::size_t i = 0; i < Alphabet.size(); ++i)
  {
    values[static_cast<std::uint8_t>(Alphabet[i])] = static_cast<std::uint8_t>(i);
  }
  while (!text.empty() && text.back() == '=')
  {
    text.remove_suffix(1);
  }
  bytes.clear();
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t group = 0;
  int bits = 0;
  for (const char digit : text)
  {
    const std::uint8_t value = values[static_cast<std::uint8_t>(digit)];
    if (value == none)
    {
      return false;
    }
    group = group << 6 | value;
    bits += 6;
    if (bits >= 8)
    {
      bits -= 8;
      bytes.push_back(static_cast<std::uint8_t>(group >> bits));
    }
  }
  return true;
}

/// Escapes a text for HTML, attributes included.
std::string Escaped(const std::string& text)
{
  std::string escaped;
  for (const char character : text)
  {
    switch (character)
    {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += character;
    }
  }
  return escaped;
}

/// A page with texts in the place of its marks. Marks in these texts stay.
std::string Filled(const std::string& page, const std::map<std::string_view, std::string>& texts)
{
  std::string filled;
  std::size_t done = 0;
  for (std::size_t at = page.find('@'); at != std::string::npos; at = page.find('@', at))
  {
    const std::size_t end = page.find('@', at + 1);
    const auto text = end == std::string::npos
      ? texts.end()
      : texts.find(std::string_view(page).substr(at, end + 1 - at));
    if (text == texts.end())
    {
      ++at;
      continue;
    }
    filled.append(page, done, at - done);
    filled += text->second;
    done = at = end + 1;
  }
  return filled.append(page, done);
}

}

Bytes PageOf(const Bytes& file, const Bytes& poster, const ViewTexts& texts)
{
  Bytes picture;
  AppendBase64(poster, picture);
  const std::string begin = Filled(ViewPageBegin(),
    { { "@TITLE@", Escaped(texts.Title.empty() ? "Isosurfaces" : texts.Title) },
      { "@CAPTION@", Escaped(texts.Caption) }, { "@CITATION@", Escaped(texts.Citation) },
      { "@POSTER@", { picture.begin(), picture.end() } } });
  Bytes page(begin.begin(), begin.end());
  AppendBase64(file, page);
  const std::string end = ViewPageEnd();
  page.insert(page.end(), end.begin(), end.end());
  return page;
}

bool IsPage(const Bytes& bytes)
{
  constexpr std::string_view begin = "<!DOCTYPE html>";
  return bytes.size() >= begin.size() && std::equal(begin.begin(), begin.end(), bytes.begin());
}

std::string FileInPage(const Bytes& page, Bytes& file)
{
  const std::string_view text(reinterpret_cast<const char*>(page.data()), page.size());
  const std::size_t mark = text.find(BeginOfFile);
  const std::size_t begin = mark == std::string_view::npos ? mark : mark + BeginOfFile.size();
  const std::size_t end = begin == std::string_view::npos ? begin : text.find('<', begin);
  if (end == std::string_view::npos || !ReadBase64(text.substr(begin, end - begin), file))
  {
    return "The page holds no view file.";
  }
  return {};
}

}
