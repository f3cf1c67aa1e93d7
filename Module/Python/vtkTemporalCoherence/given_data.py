# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""The data that functions of this package are given: arrays become images, VTK's data stay."""

from __future__ import annotations

from typing import Any, Iterator, Sequence

from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet, vtkDataObject, vtkDataSet, vtkImageData, vtkPolyData, vtkRectilinearGrid)

#: Distances of coordinates may differ by this share and still count as equal.
_TOLERANCE = 1e-5


def data_object(
    data: Any, spacing: Sequence[float] | None = None, origin: Sequence[float] | None = None
) -> vtkDataObject:
    """VTK's data of what was given.

    data             a data set or composite of VTK or PyVista, an array of NumPy or what converts
                     to one, indexed [z, y, x], or a DataArray of xarray with three dimensions
    spacing, origin  of an array, in the order x, y, z; None: 1 and 0. A DataArray has its own

    Raises TypeError for other data, ValueError for arrays that are no volumes, or where a spacing or
    origin is given besides one that the data have.
    """
    if isinstance(data, vtkPolyData):
        raise TypeError(
            "A surface of polygons is no volume: give the grid that it was made of, or draw it with "
            "add_mesh().")
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
