// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MediumParts_h
#define TemporalCoherence_MediumParts_h

#include "Volumes/Samples/KernelsMedium.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Colour and transmittance of a part of a ray.
struct Veil
{
  /// Composite this in front of another part.
  Veil Before(const Veil& behind) const
  {
    return { this->Color + this->Passed * behind.Color, this->Passed * behind.Passed };
  }

  glm::vec3 Color{ 0.0f };
  float Passed = 1.0f;
};

/// Integrates smooth parts of a ray. Each part is halved until its halves agree with the whole,
/// within a tolerance for visible light.
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
  /// \param enter, length world distances; enter: from the begin of the ray
  /// \return its rows, all 0, valid until the next segment
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

  /// True if the parts of another segment might find no room.
  bool AreMany() const { return this->Places.Count > MediumKernels::MediumPlaces::Most / 4; }

  /// Add a part of the last segment.
  /// \param bends true if the part may contain bends nevertheless
  void AddPart(float from, float to, bool bends);

  /// Add the whole last segment as a constant part.
  void AddEvenPart();

  /// Integrate all parts, and clear them.
  /// \param seen light of the ray in front of the parts; gets the parts added
  /// \return the world distance from the begin of the ray to the first visible part, or infinity
  double Blend(Veil& seen);

private:
  /// An estimate of a part, and its error.
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
    std::int32_t Quarters[2] = { -1, -1 }; ///< places, or -1 if they are not yet added
    std::int8_t Halved = 0;                ///< how often
    bool Bends = false;                    ///< it may contain bends
    bool IsEven = false;                   ///< it is constant
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
