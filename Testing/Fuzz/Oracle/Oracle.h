// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fuzz_Oracle_h
#define Fuzz_Oracle_h

#include "Oracle/Ear.h"
#include "Oracle/Picture.h"
#include "Oracle/Tally.h"
#include "World/World.h"

#include <array>
#include <memory>
#include <string>

namespace Fuzz
{

/// Compares what a mapper with a past answers with a mapper without one.
class Oracle
{
public:
  Oracle(World& world, Tally& tally);

  /// Make a frame by both and compare. Throws a Failure.
  void CheckFrame();

  /// Repeat a frame that need not be exact: now it is.
  void CheckRefined();

  /// The last frame is still what was shown. Where frames fail, this is what stays.
  void ExpectLastPicture(const std::string& after);

  /// A call may be refused, by one error that is not said twice.
  void ExpectOneErrorAtMost(const std::string& call) { this->ExpectErrorsAtMost(1, call); }
  void ExpectErrorsAtMost(int most, const std::string& call);
  void ExpectNoError(const std::string& call);

  /// The mapper was replaced: it has no past.
  void BeginAnew();

  /// It was told to forget its frames.
  void ForgetFrames();

  /// A frame was made that is not compared.
  void TakeFrame(const Picture& made);

  /// A mapper without a past that draws what the world shows, and nothing again.
  vtkSmartPointer<Mapper> MakeFresh() const;

  const Picture& Last() const { return this->Shown; }
  bool IsLastRefused() const { return this->IsRefused; }

private:
  void Compare(const Picture& cold, Mapper* fresh);
  void CompareCounters();
  std::string DifferenceOfPicks(Mapper* fresh) const;
  std::string CauseOf(const std::string& difference, bool inColors) const;
  bool IsPromisedExact() const;
  void ComparePromise(const Picture& cold);
  double ShortestEdge() const;

  World& Of;
  Tally& Sum;
  std::unique_ptr<Ear> Subject; ///< hears the mapper
  int Heard = 0;                ///< errors of the mapper so far
  std::string LastError;        ///< which is not said again before a frame is made
  Picture Shown;                ///< the last frame
  bool HasFrame = false, IsRefused = false, IsExact = true;
  std::array<std::array<bool, 2>, 2> AreExact{}; ///< the last frames of volumes and renderers
};

/// What Expect() is to a test, but the run ends: a Failure is thrown, for which its bytes are kept
/// and shrunk.
void Require(bool isHeld, const std::string& what);

}

#endif
