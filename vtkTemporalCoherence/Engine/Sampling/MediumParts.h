// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MediumParts_h
#define TemporalCoherence_MediumParts_h

#include "Sampling/KernelsMedium.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// A part of a ray: its colour, and the share of light that passes it.
struct Veil
{
  /// Both, one behind the other.
  Veil Before(const Veil& behind) const
  {
    return { this->Color + this->Passed * behind.Color, this->Passed * behind.Passed };
  }

  glm::vec3 Color{ 0.0f };
  float Passed = 1.0f;
};

/// Integrates parts of a ray on which all that depends on values is smooth. Each is halved until
/// its halves agree with the whole, as far as it is seen.
class MediumParts
{
public:
  explicit MediumParts(const MediumKernels::MediumLook& look)
    : Look(look)
  {
  }

  /// Begin with a ray.
  void Begin(const glm::dvec3& point, const glm::dvec3& direction)
  {
    this->Clear();
    this->Segments.Begin = point;
    this->Segments.Direction = direction;
  }

  /// Add a segment.
  /// \param enter, length world distances from where the ray begins
  /// \return its rows, all 0, until the next segment
  MediumKernels::Row* AddSegment(double enter, double length)
  {
    this->Enter.push_back(enter);
    this->Segments.Enter.push_back(static_cast<float>(enter));
    this->Segments.Length.push_back(static_cast<float>(length));
    std::vector<MediumKernels::Row>& rows = this->Segments.Rows;
    rows.resize(rows.size() + this->Look.RowsOfSegment);
    return rows.data() + rows.size() - this->Look.RowsOfSegment;
  }

  std::size_t NumberOfSegments() const { return this->Enter.size(); }

  /// True if there are so many parts that another segment might find no room.
  bool AreMany() const { return this->Places.Count > MediumKernels::MediumPlaces::Most / 4; }

  /// Add a part of the last segment.
  /// \param bends something may bend in it nevertheless
  void AddPart(float from, float to, bool bends);

  /// Add all of the last segment, in which nothing changes.
  void AddEvenPart();

  /// Integrate all parts, and forget them.
  /// \param seen what the ray has seen before; becomes what it has seen behind all parts
  /// \return the world distance from where the ray begins to the first thing seen, or infinity
  double Blend(Veil& seen);

private:
  /// What a part is, and how far that may be off.
  struct Estimate
  {
    TemporalCoherence::Veil Veil;
    float Error;
  };

  struct Part
  {
    std::int32_t Segment;
    float From, To;                        ///< shares of the segment
    std::int32_t Begin, Middle, End;       ///< places
    std::int32_t Quarters[2] = { -1, -1 }; ///< places, if it was asked for halves
    std::int8_t Halved = 0;                ///< how often
    bool Bends = false;                    ///< something may bend in it
    bool IsEven = false;                   ///< nothing changes in it
    Veil Best;
    float Error;          ///< of Best
    Estimate Front, Back; ///< halves, if they are known
  };

  void Clear();
  std::int32_t AddPlace(std::int32_t segment, float share);
  bool HasRoom() const { return this->Places.Count + 2 <= MediumKernels::MediumPlaces::Most; }
  Estimate EstimateOf(
    std::int32_t begin, std::int32_t middle, std::int32_t end, float length) const;
  bool IsOpaque(std::int32_t place) const
  {
    return this->Places.Extinction[static_cast<std::size_t>(place)] < 0.0f;
  }
  /// The length of a part, in shortest edges of a cell.
  float EdgesOf(const Part& part) const
  {
    return (part.To - part.From) * this->Look.EdgesPerLength *
      this->Segments.Length[static_cast<std::size_t>(part.Segment)];
  }
  Estimate OpaqueAt(std::int32_t place) const;
  Estimate HalfOf(const Part& part, bool isBack) const;
  bool Refine(float passed);
  void FindHalves(std::size_t from);

  const MediumKernels::MediumLook& Look;
  MediumKernels::MediumSegments Segments;
  std::vector<double> Enter; ///< of segments
  MediumKernels::MediumPlaces Places;
  std::vector<Part> Parts, Next;
};

}

#endif
