// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fuzz_Story_h
#define Fuzz_Story_h

#include <sstream>
#include <stdexcept>
#include <string>

namespace Fuzz
{

/// A contract that was broken, in words.
struct Failure : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// What was done, in words: printed where a run fails, even where it crashes.
class Story
{
public:
  /// Begin a new one.
  static void Begin() { Text().clear(); }

  /// Add a sentence.
  template <typename... Parts>
  static void Tell(const Parts&... parts)
  {
    if (IsTold())
    {
      std::ostringstream line;
      line.precision(17);
      (line << ... << parts);
      Text() += line.str() + '\n';
    }
  }

  static std::string& Text()
  {
    static std::string text;
    return text;
  }

  /// Words cost time; runs that fail are told when they are replayed.
  static bool& IsTold()
  {
    static bool isTold = false;
    return isTold;
  }
};

}

#endif
