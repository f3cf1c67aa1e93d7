# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""The data that functions of this package are given: arrays become images, VTK's data stay."""

from __future__ import annotations

import math
import os
from typing import Any, Iterator, Sequence

from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet, vtkDataObject, vtkDataSet, vtkDataSetAttributes, vtkImageData, vtkPolyData,
    vtkRectilinearGrid)

#: Distances of coordinates may differ by this share and still count as equal.
_TOLERANCE = 1e-5

#: What to do with arrays of cells where only those of points count.
_TO_POINTS = (
    "make one of that of the cells by vtkCellDataToPointData (cell_data_to_point_data() of PyVista)")


def data_object(
    data: Any, spacing: Sequence[float] | None = None, origin: Sequence[float] | None = None
) -> vtkDataObject:
    """VTK's data of what was given.

    data             a data set or composite of VTK or PyVista, an array of NumPy or what converts
                     to one, indexed [z, y, x], a DataArray of xarray with three dimensions, or the path
                     of a volume, which is read when it is needed (open_volume)
    spacing, origin  of an array, in the order x, y, z; None: 1 and 0. A DataArray has its own

    Raises TypeError for other data, ValueError for arrays that are no volumes, or where a spacing or
    origin is given besides one that the data have.
    """
    if isinstance(data, vtkPolyData):
        raise TypeError(
            "A surface of polygons is no volume: give the grid that it was made of, or draw it with "
            "add_mesh().")
    if isinstance(data, (str, os.PathLike)):
        from .large_volumes import open_volume
        data = open_volume(data)
    is_array = _is_array(data)
    has_place = not is_array or (hasattr(data, "dims") and hasattr(data, "coords"))
    if has_place and (spacing is not None or origin is not None):
        raise ValueError("Spacing and origin are those of the data: give them for plain arrays only.")
    if isinstance(data, (vtkDataSet, vtkCompositeDataSet)):
        made = data
    elif not is_array:
        raise TypeError(
            f"The data must be a data set of PyVista or VTK or an array of three dimensions, not "
            f"{type(data).__name__}: of lists make an array by numpy.asarray(), of a filter give its "
            f"output.")
    elif has_place:
        made = _of_coordinates(data)
    else:
        from .numpy_support import numpy_to_image
        made = numpy_to_image(
            _as_numpy(data),
            (1.0, 1.0, 1.0) if spacing is None else _three("spacing", spacing, True),
            (0.0, 0.0, 0.0) if origin is None else _three("origin", origin, False))
    if isinstance(made, (vtkImageData, vtkRectilinearGrid)) and 1 in made.GetDimensions():
        raise ValueError(
            f"A volume must have two samples or more along each axis, not {made.GetDimensions()} "
            f"along x, y and z: give several slices.")
    return made


def leaves(grid: vtkDataObject) -> Iterator[vtkDataSet]:
    """The data sets of blocks, or the one that there is."""
    if not isinstance(grid, vtkCompositeDataSet):
        yield grid
        return
    iterator = grid.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        if isinstance(iterator.GetCurrentDataObject(), vtkDataSet):
            yield iterator.GetCurrentDataObject()
        iterator.GoToNextItem()


def attributes_of(leaf: vtkDataSet, place: str) -> vtkDataSetAttributes:
    """The arrays at a place, "point" or "cell"."""
    return leaf.GetPointData() if place == "point" else leaf.GetCellData()


def arrays_of(grid: vtkDataObject, name: str | None, place: str) -> list[vtkDataArray]:
    """The arrays of that name of all blocks; those without a name that are the active scalars."""
    attributes = (attributes_of(leaf, place) for leaf in leaves(grid))
    found = (each.GetScalars() if name is None else each.GetArray(name) for each in attributes)
    return [array for array in found if array is not None]


def chosen_array(
    grid: vtkDataObject, scalars: str | None, places: Sequence[str]
) -> tuple[str | None, str]:
    """The name of the array to draw, and where it is: "point" or "cell". There is no name if active
    scalars have none.

    scalars  its name. None: the active scalars, or else the first array of numbers
    places   where it may be, the first choice first

    Raises TypeError for what is no name, ValueError if there is no such array.
    """
    if scalars is None:
        return _default_array(grid, places)
    if not isinstance(scalars, str):
        raise TypeError(
            f"scalars must be the name of an array, not {type(scalars).__name__}: add the array to "
            f"the data, or give it instead of the data.")
    for place in places:
        if arrays_of(grid, scalars, place):
            return scalars, place
    names = sorted({
        name for place in places for leaf in leaves(grid) for name in _names_of(leaf, place)})
    if arrays_of(grid, scalars, "cell"):
        remedy = _TO_POINTS
    else:
        remedy = f"choose of {', '.join(names)}" if names else "the data have no arrays of numbers"
    raise ValueError(f"There is no array {scalars!r} at the {_named(places)}: {remedy}.")


def _default_array(grid: vtkDataObject, places: Sequence[str]) -> tuple[str | None, str]:
    for leaf in leaves(grid):
        for place in places:
            scalars = attributes_of(leaf, place).GetScalars()
            if scalars is not None:
                return scalars.GetName() or None, place
        for place in places:
            for name in _names_of(leaf, place):
                return name, place
    remedy = "add one, or give it as scalars" if "cell" in places else f"add one, or {_TO_POINTS}"
    raise ValueError(f"The data have no array of numbers at the {_named(places)}: {remedy}.")


def _names_of(leaf: vtkDataSet, place: str) -> list[str]:
    """The names of arrays of numbers, in order."""
    attributes = attributes_of(leaf, place)
    return [attributes.GetArrayName(index) for index in range(attributes.GetNumberOfArrays())
            if attributes.GetArray(index) is not None and attributes.GetArrayName(index)]


def _named(places: Sequence[str]) -> str:
    return " or ".join(f"{place}s" for place in sorted(places, reverse=True))


def finite_number(what: str, given: Any) -> float:
    """An argument as a number; ValueError if it is none."""
    try:
        number = float(given)
    except (TypeError, ValueError):
        number = math.nan
    if not math.isfinite(number):
        raise ValueError(f"{what} must be a finite number, not {given!r}.")
    return number


def _is_array(data: Any) -> bool:
    return hasattr(data, "__array__") and hasattr(data, "shape") and not isinstance(data, type)


def _as_numpy(data: Any) -> Any:
    """A NumPy array; a masked one stays what it is, as it is refused with a remedy."""
    import numpy
    return data if isinstance(data, numpy.ndarray) else numpy.asarray(data)


def _three(what: str, given: Any, is_positive: bool) -> tuple[float, float, float]:
    try:
        x, y, z = (float(number) for number in ([] if isinstance(given, str) else given))
    except (TypeError, ValueError):
        raise ValueError(
            f"The {what} must be three numbers, for x, y and z, not {given!r}.") from None
    numbers = (x, y, z)
    if not all(abs(number) < float("inf") for number in numbers) or (
            is_positive and min(numbers) <= 0.0):
        raise ValueError(
            f"The {what} must be three finite{' positive' if is_positive else ''} numbers, not "
            f"{given!r}.")
    return numbers


def _of_coordinates(data: Any) -> vtkDataObject:
    """An image or rectilinear grid of an xarray.DataArray: its last dimension is VTK's x."""
    import numpy
    from .numpy_support import data_array, numpy_to_image

    if len(data.dims) != 3 or 0 in data.shape:
        raise ValueError(
            f"A volume must have three dimensions with samples, not {dict(zip(data.dims, data.shape))}: "
            f"select one step of the others, for example by data.isel(time=0).")
    array, axes = numpy.asarray(data), []
    for axis, name in enumerate(data.dims):
        places = (numpy.asarray(data.coords[name]) if name in data.coords
                  else numpy.arange(array.shape[axis]))
        if places.dtype.kind not in "iuf" or places.ndim != 1:
            raise ValueError(
                f"The coordinates {name!r} must be a list of numbers: convert them, or drop them by "
                f"data.drop_vars({name!r}).")
        places = places.astype(float)
        if len(places) > 1 and places[0] > places[-1]:
            array, places = numpy.flip(array, axis), places[::-1]
        if not numpy.all(numpy.isfinite(places)) or not numpy.all(numpy.diff(places) > 0.0):
            raise ValueError(
                f"The coordinates {name!r} must be finite and rise or fall from sample to sample: "
                f"sort the data by data.sortby({name!r}).")
        axes.insert(0, places)
    name = str(data.name) if data.name is not None else "scalars"
    steps = [numpy.diff(places) if len(places) > 1 else numpy.ones(1) for places in axes]
    if all(numpy.ptp(step) <= _TOLERANCE * step.mean() for step in steps):
        return numpy_to_image(
            array, [step.mean() for step in steps], [places[0] for places in axes], name)
    grid = vtkRectilinearGrid()
    grid.SetDimensions([len(places) for places in axes])
    for set_axis, places in zip(
            (grid.SetXCoordinates, grid.SetYCoordinates, grid.SetZCoordinates), axes):
        set_axis(data_array(places, (), "coordinates"))
    grid.GetPointData().SetScalars(data_array(array, (), name))
    return grid
