// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// usage: DropFile PATH X Y   Drops a file on the window at a place of the screen, as a file manager
// does: the source's side of "Drag-and-Drop Protocol for the X Window System" (XDND), version 5.
// Fails if the window does not take it within two minutes.
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <string>

namespace
{

constexpr long Version = 5;
constexpr int Attempts = 12000; // of 10 ms

class Source
{
public:
  Source(Display* display, Window target, const std::string& path)
    : X(display)
    , Target(target)
    , Data("file://" + path + "\r\n")
    , Own(XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0))
  {
  }

  bool Drop(int x, int y)
  {
    XSetSelectionOwner(this->X, this->Name("XdndSelection"), this->Own, CurrentTime);
    const auto own = static_cast<long>(this->Own);
    const auto copy = static_cast<long>(this->Name("XdndActionCopy"));
    const auto list = static_cast<long>(this->Name("text/uri-list"));
    this->Send("XdndEnter", { own, Version << 24, list, 0, 0 });
    this->Send("XdndPosition", { own, 0, (static_cast<long>(x) << 16) | y, CurrentTime, copy });
    return this->Await("XdndStatus") &&
      (this->Send("XdndDrop", { own, 0, CurrentTime, 0, 0 }), this->Await("XdndFinished"));
  }

private:
  Atom Name(const char* name) { return XInternAtom(this->X, name, False); }

  void Send(const char* type, std::initializer_list<long> values)
  {
    XEvent event;
    std::memset(&event, 0, sizeof(event));
    event.xclient.type = ClientMessage;
    event.xclient.window = this->Target;
    event.xclient.message_type = this->Name(type);
    event.xclient.format = 32;
    int i = 0;
    for (const long value : values)
    {
      event.xclient.data.l[i++] = value;
    }
    XSendEvent(this->X, this->Target, False, NoEventMask, &event);
    XFlush(this->X);
  }

  // Meanwhile the target may ask for the data.
  bool Await(const char* type)
  {
    for (int attempt = 0; attempt < Attempts; ++attempt)
    {
      while (XPending(this->X) > 0)
      {
        XEvent event;
        XNextEvent(this->X, &event);
        if (event.type == SelectionRequest)
        {
          this->Answer(event.xselectionrequest);
        }
        else if (event.type == ClientMessage && event.xclient.message_type == this->Name(type))
        {
          return true;
        }
      }
      usleep(10000);
    }
    return false;
  }

  void Answer(const XSelectionRequestEvent& request)
  {
    XChangeProperty(this->X, request.requestor, request.property, request.target, 8,
      PropModeReplace, reinterpret_cast<const unsigned char*>(this->Data.c_str()),
      static_cast<int>(this->Data.size()));
    XEvent answer;
    std::memset(&answer, 0, sizeof(answer));
    answer.xselection.type = SelectionNotify;
    answer.xselection.requestor = request.requestor;
    answer.xselection.selection = request.selection;
    answer.xselection.target = request.target;
    answer.xselection.property = request.property;
    answer.xselection.time = request.time;
    XSendEvent(this->X, request.requestor, False, NoEventMask, &answer);
    XFlush(this->X);
  }

  Display* X;
  Window Target;
  std::string Data;
  Window Own;
};

}

int main(int argc, char* argv[])
{
  const std::unique_ptr<Display, int (*)(Display*)> display(
    argc == 4 ? XOpenDisplay(nullptr) : nullptr, XCloseDisplay);
  if (!display)
  {
    std::fprintf(stderr, "usage: DropFile PATH X Y, with a display\n");
    return 1;
  }
  const int x = std::atoi(argv[2]), y = std::atoi(argv[3]);
  const Window root = DefaultRootWindow(display.get());
  Window target = None;
  int xThere = 0, yThere = 0;
  XTranslateCoordinates(display.get(), root, root, x, y, &xThere, &yThere, &target);
  if (target == None)
  {
    std::fprintf(stderr, "There is no window at %d, %d\n", x, y);
    return 1;
  }
  return Source(display.get(), target, argv[1]).Drop(x, y) ? 0 : 1;
}
