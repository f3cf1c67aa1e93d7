// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Model_h
#define Model_h

#include "Files/ColorArrays.h"
#include "Files/Volume.h"
#include "Model/Session.h"
#include "Model/VolumeView.h"
#include "View/Histogram.h"

// What is to be shown next: another file, or another array or time step of the one that is open;
// and what was read for it.
struct Request
{
  Session Wanted;
  bool IsSameFile = false;      // view and mapper stay
  bool KeepsSurfaces = false;   // as they fit into the new values
  Volume Data = {};             // if it is there already, it is not read
  Histogram Samples = {};       // all that follows is
  std::vector<int> Labels = {}; // whole numbers of the samples, ascending, if they may be labels
  std::vector<LabelLook> Named = {}; // labels that a file beside the volume tells
  VolumeView::Mapping Mapper = {};   // may be null
  ColorArrays Coloring = {};
};

// What is shown, and what can be done with it. It knows nothing of windows and widgets.
class Model
{
public:
  // from: the viewer's place at first ("+y"; empty: what suits the file); up: the way up.
  Model(const std::string& from, const std::string& up);

  // Opening, in two steps: what takes long, in any thread, and what is seen. The first may throw
  // UserError; what was shown stays then.
  static void Load(Request& request, const Progress& progress);
  void Adopt(Request& request);
  void Open(const Session& session);

  bool IsOpen() const { return this->Shown.Data != nullptr; }
  const Session& State() const { return this->Current; }
  const Look& Settings() const { return this->Current.Settings; }
  const Histogram& Counted() const { return this->Samples; }
  const Volume& Data() const { return this->Shown; }
  std::string Description() const; // "256 x 256 x 110 uchar"

  // What to load for another array or time step. Throw UserError.
  Request OtherArray(const std::string& name, int component) const;
  Request NextArrayOfFile() const;
  Request OtherTimeStep(int step) const;

  // Values are made to fit the data. Draws nothing; with isShown false, nothing that a picture
  // depends on is touched until Apply().
  void SetSettings(const Look& look, bool isShown = true);
  void Apply();

  // False if it has no effect on what is shown.
  bool Offers(const Setting& row) const { return !row.For || (this->*row.For)(); }
  std::array<double, 2> RangeOf(const Setting& number) const;
  bool DrawsMesh() const { return this->View.IsMesh(); }
  bool DrawsImage() const { return !this->View.IsMesh(); }
  bool CanBeLabels() const { return !this->Labels.empty(); }
  // Labels that the data have, ascending, but for 0, which is outside of all.
  const std::vector<int>& LabelsOfData() const { return this->Labels; }
  bool DrawsLabels() const
  {
    return this->CanBeLabels() && this->Settings().Choice(Row::Drawing) == Drawing::Labels;
  }
  bool Blends() const { return this->DrawsImage() && this->Settings().Blends(); }
  bool DrawsSurfaces() const { return !this->Blends(); } // of isovalues or of labels
  bool HasIsovalues() const { return this->DrawsSurfaces() && !this->DrawsLabels(); }
  // Projections show one value of a ray, in grey.
  bool Projects() const { return this->Blends() && this->Settings().IsProjection(); }
  bool AddsUp() const
  {
    return this->Blends() && this->Settings().Choice(Row::Drawing) >= Drawing::Average;
  }
  bool HasNodes() const { return this->Blends() && !this->Projects(); }
  bool HasMarkers() const { return !this->Projects() && !this->DrawsLabels(); }
  bool CanShowCut() const { return this->View.CanShowCut(); }
  // Surfaces or labels have the colours of another array.
  bool ColorsByArray() const
  {
    return this->DrawsSurfaces() && !this->Settings().ColorBy.Name.empty();
  }
  bool CanColorByArray() const; // there is another one, or another component
  // Surfaces, nodes, or the samples on the plane have its colours.
  bool ShowsPalette() const
  {
    return this->HasMarkers() &&
      (!this->ColorsByArray() || this->Settings().Choice(Row::Cut) == OnCut::Colors);
  }
  bool HasGreys() const
  {
    return this->Projects() ||
      (this->CanShowCut() && this->Settings().Values[Row::Clipping] != 0.0 &&
        this->Settings().Choice(Row::Cut) == OnCut::Greys);
  }
  // The surfaces, the nodes of the blended volume, or the ends of the greys.
  auto MarkersIn() const
  {
    return this->DrawsSurfaces() ? &Look::Surfaces : this->Projects() ? &Look::Greys : &Look::Nodes;
  }
  std::vector<Marker>& MarkersOf(Look& look) const { return look.*this->MarkersIn(); }
  const std::vector<Marker>& Markers() const { return this->Settings().*this->MarkersIn(); }
  // Values by their place in the range, 0 to 1.
  double ValueAt(double share) const
  {
    return this->Samples.Range[0] + share * (this->Samples.Range[1] - this->Samples.Range[0]);
  }
  double ShareOf(double value) const
  {
    return (value - this->Samples.Range[0]) / (this->Samples.Range[1] - this->Samples.Range[0]);
  }
  // One of as many as 8 bits have.
  double StepOfValues() const { return (this->Samples.Range[1] - this->Samples.Range[0]) / 256.0; }

  // A number of a look. The opacity is that of a marker.
  double NumberOf(const Setting& number, const Look& look, std::size_t marker) const;
  void SetNumber(const Setting& number, Look& look, std::size_t marker, double value) const;
  void SetChoice(Look& look, std::size_t choice, int word) const;
  void ForgetPreset(Look& look) const; // if its nodes were changed otherwise

  // Names and looks of labels as a file tells them, in a look. Throws UserError.
  static void NameLabels(Look& look, const std::string& path);

  void ResetView();
  void LookFrom(const std::string& from); // "+z": an axis
  void Save(const std::string& path);     // a session; throws UserError

  // Whether the choices say so and it was neither built nor stopped in this view.
  bool WantsIsomapAhead();
  void NoteIsomap() { this->Ahead = this->PresentSight(); } // it is to be built now

  VolumeView View;

private:
  // What an isomap belongs to: the camera, the size of the picture, the surface mode.
  std::vector<double> PresentSight();
  Look Fitted(Look look) const;
  std::vector<Marker> NodesOf(const char* preset) const;
  std::vector<LabelLook> LabelsFor(std::vector<LabelLook> labels) const;

  std::string From, Up;
  Session Current;
  Volume Shown;
  Histogram Samples;
  std::vector<int> Labels;   // none if the samples can be no labels
  std::vector<double> Ahead; // the sight whose isomap was built, or stopped
};

#endif
