// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Quoted_h
#define Quoted_h

#include <string>

// A text for one line of a terminal: UTF-8, in which whatever could steer the terminal or hide a
// part of the line is shown as its bytes, "\x1b". That are control characters, what reverses the
// direction of writing, line separators, and bytes that are no UTF-8.
std::string Printable(const std::string& text);

// A printable text; what is much too long is left out in the middle.
std::string Shortened(const std::string& text);

// Such a text between quotes, for text of the user's or of a file in a message.
std::string Quoted(const std::string& text);

#endif
