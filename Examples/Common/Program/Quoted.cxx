// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program/Quoted.h"

#include <cstdint>

namespace
{

constexpr std::size_t MostBytes = 240; // of a quoted text; many paths are long
constexpr std::size_t BytesOfEnd = 80; // which is where the name of a file is

// A character of UTF-8: its bytes, and its number.
struct Character
{
  std::size_t Size = 0; // 0: the bytes are no UTF-8
  std::uint32_t Number = 0;
};

Character CharacterAt(const std::string& text, std::size_t at)
{
  const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  if (first < 0x80)
  {
    return { 1, first };
  }
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || at + size > text.size())
  {
    return {};
  }
  std::uint32_t number = first & (0xffu >> (size + 1));
  for (std::size_t i = at + 1; i < at + size; ++i)
  {
    if ((byte(i) & 0xc0) != 0x80)
    {
      return {};
    }
    number = number << 6 | (byte(i) & 0x3fu);
  }
  constexpr std::uint32_t Least[] = { 0, 0, 0x80, 0x800, 0x10000 };
  const bool isSurrogate = number >= 0xd800 && number <= 0xdfff;
  return number < Least[size] || number > 0x10ffff || isSurrogate ? Character{}
                                                                  : Character{ size, number };
}

bool IsHarmless(std::uint32_t character)
{
  const bool isControl = character < 0x20 || (character >= 0x7f && character < 0xa0);
  // Invisible ones, and those that end lines or reverse the direction of writing.
  const bool isFormat = character == 0x00ad || character == 0x061c || character == 0xfeff ||
    (character >= 0x200b && character <= 0x200f) || (character >= 0x2028 && character <= 0x202e) ||
    (character >= 0x2060 && character <= 0x206f) || (character >= 0xfff9 && character <= 0xfffc) ||
    (character >= 0xe0000 && character <= 0xe0fff);
  return !isControl && !isFormat;
}

void AppendBytes(const std::string& text, std::size_t begin, std::size_t size, std::string& to)
{
  constexpr char Digits[] = "0123456789abcdef";
  for (std::size_t i = begin; i < begin + size; ++i)
  {
    const auto byte = static_cast<unsigned char>(text[i]);
    to += { '\\', 'x', Digits[byte >> 4], Digits[byte & 15] };
  }
}

// Where a character begins, at a place or after it.
std::size_t NextCharacter(const std::string& text, std::size_t at)
{
  while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80)
  {
    ++at;
  }
  return at;
}

}

std::string Printable(const std::string& text)
{
  std::string shown;
  for (std::size_t at = 0; at < text.size();)
  {
    const Character character = CharacterAt(text, at);
    const std::size_t size = character.Size > 0 ? character.Size : 1;
    if (character.Size > 0 && IsHarmless(character.Number))
    {
      shown.append(text, at, size);
    }
    else
    {
      AppendBytes(text, at, size, shown);
    }
    at += size;
  }
  return shown;
}

std::string Shortened(const std::string& text)
{
  if (text.size() <= MostBytes)
  {
    return Printable(text);
  }
  const std::size_t begin = NextCharacter(text, MostBytes - BytesOfEnd);
  const std::size_t end = NextCharacter(text, text.size() - BytesOfEnd);
  return Printable(text.substr(0, begin)) + " ... " + Printable(text.substr(end));
}

std::string Quoted(const std::string& text)
{
  return "'" + Shortened(text) + "'";
}
