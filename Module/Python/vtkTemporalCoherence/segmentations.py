# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Segmentations in one call: images whose samples are labels, each with a colour and a name."""

from __future__ import annotations

import colorsys
import math
from typing import Any, Iterable, Mapping, Sequence, Union

from vtkmodules.vtkCommonCore import vtkLookupTable, vtkStringArray, vtkVariant, vtkVariantArray
from vtkmodules.vtkCommonDataModel import vtkImageData

from .given_data import arrays_of, chosen_array, data_object, finite_number
from .isosurfaces import checked_color
from .mapper_support import mapper_of
from .pictures import PicturedVolume
from .vtkTemporalCoherence import vtkTemporalCoherenceVolumeMapper

#: A label, or its name.
LabelOrName = Union[int, str]

#: Steps of hues that stay apart, however many there are: the golden ratio.
_GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)


class SegmentationVolume(PicturedVolume):
    """What segmentation() makes: a volume that shows the surfaces of labels.

    Labels are numbers or names. GetMapper() and GetProperty() lead to all other settings.
    """

    _names: dict[int, str]
    _looks: dict[int, tuple[float, float, float, float]]
    _outside: int
    _shown: set[int]
    _samples: Any  # the array of VTK

    @property
    def labels(self) -> tuple[int, ...]:
        """All labels of the data but the outside, ascending."""
        return tuple(sorted(self._looks))

    @property
    def names(self) -> dict[int, str]:
        """The names of labels that have one."""
        return dict(self._names)

    @property
    def shown(self) -> tuple[int, ...]:
        """The labels that are drawn. Set labels or names to draw these alone."""
        return tuple(sorted(self._shown))

    @shown.setter
    def shown(self, labels: Iterable[LabelOrName]) -> None:
        self._shown = {self._label_of(label) for label in _several(labels)}
        self._update()

    def set_color(self, label: LabelOrName, color: Any) -> None:
        """Change the colour of a label: a name, "#rrggbb" or three numbers."""
        self._keep_color(label, color)
        self._update()

    def set_opacity(self, label: LabelOrName, opacity: float) -> None:
        """Change the opacity of a label, from 0 to 1."""
        self._keep_opacity(label, opacity)
        self._update()

    def data_changed(self, within: Any = None) -> None:
        """Tell that labels were written into the array: the next picture shows them.

        within  where, as an index of the array, such as numpy.s_[10:20, 30:40, 5]. None: anywhere.
                If a stroke's place is told, no other samples are read

        Labels that are new get colours, and are drawn.

        Raises IndexError and TypeError for what is no index of the array.
        """
        from vtkmodules.util.numpy_support import vtk_to_numpy
        image = self.GetMapper().GetInputDataObject(0, 0)
        samples = vtk_to_numpy(self._samples).reshape(image.GetDimensions()[::-1])
        if within is None:
            self._samples.Modified()
        else:
            _tell_change(image, self._samples, samples.shape, within)
        new = set(_labels_in(samples if within is None else samples[within]))
        new -= {self._outside, *self._looks}
        for label in sorted(new):
            self._looks[label] = (*_color_of(len(self._looks)), 1.0)
        if new:
            self._shown |= new
            self._update()

    def _keep_color(self, label: LabelOrName, color: Any) -> None:
        number = self._label_of(label)
        self._looks[number] = (*checked_color(color), self._looks[number][3])

    def _keep_opacity(self, label: LabelOrName, opacity: float) -> None:
        number = self._label_of(label)
        self._looks[number] = (*self._looks[number][:3], _checked_opacity(opacity))

    def _label_of(self, label: LabelOrName) -> int:
        if isinstance(label, str):
            numbers = [number for number, name in self._names.items() if name == label]
            if not numbers:
                raise ValueError(
                    f"No label is called {label!r}; names are "
                    f"{', '.join(self._names.values()) or 'none'}.")
            label = numbers[0]
        if not hasattr(label, "__index__") or int(label) not in self._looks:
            raise ValueError(f"The data have no label {label!r}, or it is the outside.")
        return int(label)

    def _update(self) -> None:
        values, texts = vtkVariantArray(), vtkStringArray()
        table = vtkLookupTable()
        table.SetNumberOfTableValues(len(self._looks) + 1)
        table.IndexedLookupOn()
        values.InsertNextValue(vtkVariant(self._outside))
        texts.InsertNextValue("outside")
        table.SetTableValue(0, 0.0, 0.0, 0.0, 0.0)
        for index, (label, look) in enumerate(self._looks.items(), 1):
            values.InsertNextValue(vtkVariant(label))
            texts.InsertNextValue(self._names.get(label, str(label)))
            opacity = look[3] if label in self._shown else 0.0
            table.SetTableValue(index, *look[:3], opacity)
        table.SetAnnotations(values, texts)
        self.GetMapper().SetLabelTable(table)


def segmentation(
    data: Any,
    names: Mapping[int, str] | None = None,
    scalars: str | None = None,
    *,
    color: Mapping[LabelOrName, Any] | None = None,
    opacity: float | Mapping[LabelOrName, float] = 1.0,
    shown: Iterable[LabelOrName] | None = None,
    outside: int = 0,
    radius: float = 2.5,
    lighting: bool = True,
    spacing: Sequence[float] | None = None,
    origin: Sequence[float] | None = None,
) -> SegmentationVolume:
    """Make a volume that shows the surfaces of labels.

        segmentation(labels, {1: "liver", 2: "spleen"}, opacity={"liver": 0.4}).save("organs.png")

    data             an image or array of whole numbers: see isosurface()
    names            of labels
    scalars          name of the array at the points. None: the active scalars, or else the first one
    color            colours of some labels: a name, "#rrggbb" or three numbers. Others get colours
                     that differ
    opacity          from 0 to 1; or those of some labels, while others are opaque
    shown            the labels to draw. None: all
    outside          the label of what is no part
    radius           how far surfaces are smoothed, in samples; 0: the faces of voxels
    lighting         False: colours without light
    spacing, origin  of a plain array, in the order x, y, z

    Raises TypeError for data of another kind, ValueError for other mistakes.
    """
    from vtkmodules.util.numpy_support import vtk_to_numpy
    import numpy
    radius = finite_number("radius", radius)
    data = data_object(data, spacing, origin)
    if not isinstance(data, vtkImageData):
        raise TypeError(
            f"Labels are drawn in images, not in {type(data).__name__}: resample it "
            f"(vtkResampleToImage, or sample() of PyVista).")
    name, place = chosen_array(data, scalars, ("point",))
    samples = vtk_to_numpy(arrays_of(data, name, place)[0])
    if not numpy.issubdtype(samples.dtype, numpy.integer) or samples.ndim > 1:
        raise ValueError(
            f"Labels are whole numbers, one for each sample, not {samples.dtype} of the shape "
            f"{samples.shape}: convert the array, for example by astype('uint16').")
    mapper = mapper_of(data, name, place)
    mapper.SetSurfaceModeToLabels()
    mapper.SetOutsideLabel(int(outside))
    mapper.SetLabelRadius(radius)

    volume = SegmentationVolume()
    volume.SetMapper(mapper)
    volume.GetProperty().SetShade(lighting)
    volume.GetProperty().SetAmbient(0.1)
    volume.GetProperty().SetDiffuse(0.9)
    found = [label for label in _labels_in(samples) if label != outside]
    volume._samples = arrays_of(data, name, place)[0]
    volume._outside = int(outside)
    volume._names = {int(label): str(called) for label, called in (names or {}).items()}
    share = 1.0 if isinstance(opacity, Mapping) else _checked_opacity(opacity)
    volume._looks = {label: (*_color_of(place), share) for place, label in enumerate(found)}
    volume._shown = set(found)
    if shown is not None:
        volume._shown = {volume._label_of(label) for label in _several(shown)}
    for label, given in (color or {}).items():
        volume._keep_color(label, given)
    for label, given in (opacity.items() if isinstance(opacity, Mapping) else ()):
        volume._keep_opacity(label, given)
    volume._update()
    return volume


def _labels_in(samples: Any) -> list[int]:
    """All labels of an array, ascending."""
    import numpy
    if samples.dtype in (numpy.uint8, numpy.uint16):
        return numpy.flatnonzero(numpy.bincount(samples.ravel())).tolist()
    return numpy.unique(samples).tolist()


def _tell_change(image: vtkImageData, samples: Any, shape: tuple[int, ...], within: Any) -> None:
    """Tell the mappers of an image where an array of its points was written, by an index [z, y, x]."""
    import numpy
    places = [numpy.arange(count) for count in shape]
    index = within if isinstance(within, tuple) else (within,)
    if len(index) > len(shape) or any(
            not isinstance(part, slice) and not hasattr(part, "__index__") for part in index):
        raise TypeError(f"within takes slices and numbers for z, y and x, not {within!r}.")
    extent = list(image.GetExtent())
    for axis, part in enumerate(index):
        chosen = numpy.atleast_1d(places[axis][part])
        first = extent[2 * (2 - axis)]
        low, high = (chosen.min(), chosen.max()) if chosen.size else (0, -1)
        extent[2 * (2 - axis):2 * (2 - axis) + 2] = [first + int(low), first + int(high)]
    vtkTemporalCoherenceVolumeMapper.ModifiedWithin(image, extent, samples)


def _color_of(place: int) -> tuple[float, float, float]:
    """A colour that differs from those of other places."""
    return colorsys.hsv_to_rgb((0.08 + place * _GOLDEN) % 1.0, 0.55 - 0.2 * (place // 7 % 2), 0.95)


def _checked_opacity(opacity: float) -> float:
    if not 0.0 <= finite_number("opacity", opacity) <= 1.0:
        raise ValueError(f"An opacity must be from 0 to 1, not {opacity!r}.")
    return float(opacity)


def _several(labels: Iterable[LabelOrName]) -> Iterable[LabelOrName]:
    """One label counts as a list of one."""
    return [labels] if isinstance(labels, (str, int)) else labels
