# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Isosurfaces of arrays and of VTK's and PyVista's data in one call, with the names of PyVista's
arguments."""

from __future__ import annotations

import math
from typing import Any, Callable, Iterable, Sequence

from vtkmodules.vtkCommonColor import vtkNamedColors
from vtkmodules.vtkCommonCore import vtkScalarsToColors
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet, vtkDataObject, vtkImageData, vtkPiecewiseFunction, vtkRectilinearGrid)
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

from .given_data import arrays_of, attributes_of, chosen_array, data_object, finite_number
from .mapper_support import mapper_of
from .pictures import PicturedVolume
from .vtkTemporalCoherence import vtkTemporalCoherenceVolumeMapper

__all__ = ["IsosurfaceVolume", "isosurface"]

#: What add_mesh() of PyVista draws with, if nothing else is asked for.
_DEFAULT_COLOR = "lightblue"

#: Names that Matplotlib has, and PyVista with it, and VTK not.
_LETTERS = {
    "b": "blue", "c": "cyan", "g": "green", "k": "black", "m": "magenta", "r": "red", "w": "white",
    "y": "yellow"}

#: Colours of arrays by share of their range, if nothing else is asked for.
_DIVERGING = (
    (0.0, (0.231, 0.298, 0.753)), (0.5, (0.865, 0.865, 0.865)), (1.0, (0.706, 0.016, 0.149)))

#: Places of a colour map that become nodes of a transfer function.
_NODES = 256


class IsosurfaceVolume(PicturedVolume):
    """What isosurface() makes: a volume whose mapper is a vtkTemporalCoherenceVolumeMapper.

    Set `values` to move its surfaces, for example from a slider:

        plotter.add_slider_widget(lambda value: setattr(surface, "values", value), (0, 100))

    GetMapper() and GetProperty() lead to all other settings.
    """

    _colors: Sequence[tuple[float, float, float]] | None = None
    _color_of: Callable[[float], tuple[float, float, float]] | None = None
    _clim: tuple[float, float] = (0.0, 0.0)
    _opacities: Sequence[float] = (1.0,)

    @property
    def values(self) -> tuple[float, ...]:
        """The isovalues: one number or several may be set."""
        contours = self.GetProperty().GetIsoSurfaceValues()
        return tuple(contours.GetValue(i) for i in range(contours.GetNumberOfContours()))

    @values.setter
    def values(self, values: float | Iterable[float]) -> None:
        values = _checked_values(values)
        _check_count("colours", self._colors, values)
        _check_count("opacities", self._opacities, values)
        contours = self.GetProperty().GetIsoSurfaceValues()
        contours.SetNumberOfContours(len(values))
        for index, value in enumerate(values):
            contours.SetValue(index, value)
        self._set_colors(values)
        opacity = vtkPiecewiseFunction()
        for value, share in zip(values, _for_each(self._opacities, values)):
            opacity.AddPoint(value, share)
        self.GetProperty().SetScalarOpacity(opacity)

    @property
    def color_table(self) -> vtkScalarsToColors:
        """The colours: of the array that `color_by` named, or else of the isovalues."""
        table = self.GetMapper().GetColorTable()
        return table if table is not None else self.GetProperty().GetRGBTransferFunction()

    def _set_colors(self, values: Sequence[float]) -> None:
        colors = vtkColorTransferFunction()
        if self._colors is not None:
            for value, color in zip(values, _for_each(self._colors, values)):
                colors.AddRGBPoint(value, *color)
        else:
            low, high = self._clim
            places = [low + (high - low) * i / (_NODES - 1) for i in range(_NODES)]
            for value in (*places, *values):
                colors.AddRGBPoint(value, *self._color_of(value))
        self.GetProperty().SetColor(colors)


def isosurface(
    grid: Any,
    values: float | Iterable[float],
    scalars: Any = None,
    *,
    preference: str = "point",
    component: int | None = None,
    color: Any = None,
    cmap: Any = None,
    clim: Sequence[float] | None = None,
    color_by: Any = None,
    opacity: float | Sequence[float] = 1.0,
    lighting: bool = True,
    ambient: float = 0.0,
    diffuse: float = 1.0,
    specular: float = 0.0,
    specular_power: float = 100.0,
    smooth_shading: bool = False,
    ambient_occlusion: bool | float = False,
    occlusion_radius: float | None = None,
    solid: bool = False,
    spacing: Sequence[float] | None = None,
    origin: Sequence[float] | None = None,
) -> IsosurfaceVolume:
    """Make a volume that shows isosurfaces of a grid or array: a picture by itself, and an actor for
    PyVista's plotters and VTK's renderers.

        isosurface(array, 150).save("picture.png")   # the last line of a notebook's cell shows it
        plotter.add_actor(isosurface(grid, 150))
        plotter.add_actor(isosurface(grid, [100, 200], "pressure", cmap="viridis", opacity=[0.3, 1]))
        plotter.add_actor(isosurface(grid, 150, "pressure", color_by="temperature"))
        renderer.AddVolume(isosurface(image, 150))

    grid            an ImageData, RectilinearGrid, StructuredGrid, ExplicitStructuredGrid,
                    UnstructuredGrid or MultiBlock of PyVista, a data set or composite of VTK, an
                    array of NumPy (or what converts to one) that is indexed [z, y, x], or a
                    DataArray of xarray with three dimensions and the coordinates of its samples
    values          the isovalue, or several of them
    scalars         name of the array, or an array with a number for each point or cell. None: the
                    active scalars, or else the first array
    preference      "point" or "cell": where an array of that name is looked for first
    component       which component of an array that has several. None: the length of the vectors
    color           a name, "#rrggbb" or three numbers; several for several values. None: light blue
    cmap            instead of a colour: a colour map of Matplotlib or its name, a list of colours,
                    or a lookup table of PyVista or VTK
    clim            values at the ends of the colour map. None: the range of the array. A lookup
                    table has its own
    color_by        another array that gives the surfaces their colours: its name, or an array with a
                    number for each point or cell (of an image also indexed [z, y, x]), or with a
                    vector, whose length counts. cmap and clim are its own then; without cmap,
                    colours go from blue over white to red. color_table is for a vtkScalarBarActor
    opacity         from 0 to 1; several for several values
    lighting        False: colours without light
    ambient, diffuse, specular, specular_power
                    the parts of light, which are not negative
    smooth_shading  average normals at the points of a mesh. Those of images are always smooth
    ambient_occlusion
                    True: hollows are darker, so that depth shows; or how much, from 0 to 1. In a
                    window, vtkTemporalCoherenceRefiner renders until that is final
    occlusion_radius
                    how far surfaces keep light away. None: an eighth of the longest edge
    solid           True: draw all that is at least the value as a solid, closed where the grid ends
    spacing, origin
                    of a plain array, in the order x, y, z. None: 1 and 0

    Data are not copied, if arrays are such as numpy_to_image() shares. Arrays of cells are averaged
    at the points. PyVista itself is not needed.

    Raises TypeError for what is no grid or of another kind than these, ValueError for other
    mistakes. What the mapper refuses, it says when it draws.
    """
    grid = data_object(grid, spacing, origin)
    values = _checked_values(values)
    if color is not None and cmap is not None:
        raise ValueError("A surface has a colour or a colour map: give color or cmap, not both.")
    if preference not in ("point", "cell"):
        raise ValueError(f"The preference must be 'point' or 'cell', not {preference!r}.")
    places = ("point", "cell") if preference == "point" else ("cell", "point")
    if scalars is None or isinstance(scalars, str):
        name, place = chosen_array(grid, scalars, places)
    else:
        grid, name, place = _with_array(grid, scalars, places, "isosurface scalars")
    color_name, color_place = None, place
    if color_by is not None:
        if color is not None:
            raise ValueError(
                "Surfaces have one colour or colours by an array: give color or color_by, not both.")
        if isinstance(color_by, str):
            color_name, color_place = chosen_array(grid, color_by, places)
        else:
            grid, color_name, color_place = _with_array(grid, color_by, places, "isosurface colours")

    mapper = mapper_of(grid, name, place)
    is_vector = _choose_component(mapper, grid, name, place, component)
    mapper.SetSmoothMeshNormals(smooth_shading)
    mapper.SetSurfaceMode(mapper.THRESHOLD if solid else mapper.CROSSING)
    _set_occlusion(mapper, ambient_occlusion, occlusion_radius)

    volume = IsosurfaceVolume()
    volume.SetMapper(mapper)
    appearance = volume.GetProperty()
    appearance.SetInterpolationTypeToLinear()
    appearance.SetShade(lighting)
    appearance.SetAmbient(_checked_part("ambient", ambient))
    appearance.SetDiffuse(_checked_part("diffuse", diffuse))
    appearance.SetSpecular(_checked_part("specular", specular))
    appearance.SetSpecularPower(_checked_part("specular_power", specular_power))

    volume._opacities = _checked_opacities(opacity)
    if color_name is not None:
        _set_color_array(mapper, grid, color_name, color_place, cmap, clim)
        cmap = None
    if cmap is None:
        volume._colors = _checked_colors(_DEFAULT_COLOR if color is None else color)
    else:
        measured = -1 if is_vector and component is None else component or 0
        volume._clim = _checked_clim(clim, grid, name, place, measured)
        volume._color_of = _color_map(cmap, volume._clim)
    volume.values = values
    return volume


def _set_color_array(
    mapper: vtkTemporalCoherenceVolumeMapper, grid: vtkDataObject, name: str, place: str, cmap: Any,
    clim: Sequence[float] | None,
) -> None:
    components = max(array.GetNumberOfComponents() for array in arrays_of(grid, name, place))
    component = -1 if components > 1 else 0
    mapper.SetColorArrayName(name)
    mapper.SetColorArrayOnCells(place == "cell")
    mapper.SetColorArrayComponent(component)
    if isinstance(cmap, vtkScalarsToColors):
        mapper.SetColorTable(cmap)
        return
    low, high = _checked_clim(clim, grid, name, place, component)
    table = vtkColorTransferFunction()
    if cmap is None:
        table.SetColorSpaceToDiverging()
        for share, color in _DIVERGING:
            table.AddRGBPoint(low + share * (high - low), *color)
    else:
        color_of = _color_map(cmap, (low, high))
        for i in range(_NODES):
            value = low + (high - low) * i / (_NODES - 1)
            table.AddRGBPoint(value, *color_of(value))
    mapper.SetColorTable(table)


def _set_occlusion(
    mapper: vtkTemporalCoherenceVolumeMapper, strength: bool | float, radius: float | None
) -> None:
    try:
        strength, radius = float(strength), 0.0 if radius is None else float(radius)
    except (TypeError, ValueError):
        strength = math.nan
    if not (0.0 <= strength <= 1.0 and 0.0 <= radius < math.inf):
        raise ValueError(
            f"ambient_occlusion must be True, False or a number from 0 to 1, and occlusion_radius a "
            f"length or None, not {strength!r} and {radius!r}.")
    mapper.SetAmbientOcclusion(strength > 0.0)
    if strength > 0.0:
        mapper.SetAmbientOcclusionStrength(strength)
        mapper.SetAmbientOcclusionRadius(radius)


def _with_array(
    grid: vtkDataObject, scalars: Any, places: Sequence[str], name: str
) -> tuple[vtkDataObject, str, str]:
    """A shallow copy of a grid that has an array of that name besides."""
    import numpy
    from .numpy_support import data_array

    scalars = numpy.asarray(scalars)
    if isinstance(grid, vtkCompositeDataSet):
        raise TypeError(
            "Blocks have arrays of their own: give the name of one, not an array.")
    if isinstance(grid, (vtkImageData, vtkRectilinearGrid)) and (
            scalars.shape == tuple(grid.GetDimensions())[::-1]):
        scalars = scalars.reshape(-1)
    counts = {"point": grid.GetNumberOfPoints(), "cell": grid.GetNumberOfCells()}
    place = next((place for place in places if scalars.shape[:1] == (counts[place],)), None)
    if place is None or scalars.ndim > 2:
        raise ValueError(
            f"An array of the shape {scalars.shape} does not fit the grid: give a flat one with a number "
            f"for each of its {counts['point']} points or {counts['cell']} cells.")
    copy = grid.NewInstance()
    copy.ShallowCopy(grid)
    attributes_of(copy, place).AddArray(data_array(scalars, scalars.shape[1:], name))
    return copy, name, place


def _choose_component(
    mapper: vtkTemporalCoherenceVolumeMapper, grid: vtkDataObject, name: str | None, place: str,
    component: int | None,
) -> bool:
    """Have one component of vectors drawn, or their length; are there vectors?"""
    components = max(array.GetNumberOfComponents() for array in arrays_of(grid, name, place))
    if component is not None:
        if component not in range(components):
            raise ValueError(
                f"There is no component {component!r} of {name or 'the scalars'!r}: choose from 0 to "
                f"{components - 1}.")
        mapper.SetVectorModeToComponent()
        mapper.SetVectorComponent(component)
    elif components > 1:
        mapper.SetVectorModeToMagnitude()
    return components > 1


def _checked_values(values: float | Iterable[float]) -> tuple[float, ...]:
    try:
        checked = (float(values),)
    except (TypeError, ValueError):
        try:
            checked = tuple(float(value) for value in values)
        except (TypeError, ValueError):
            raise TypeError(
                f"Isovalues must be a number or several, not {values!r}: give for example 150.0 or "
                f"[100.0, 150.0].") from None
    if not checked or not all(map(math.isfinite, checked)):
        raise ValueError(f"Isovalues must be finite numbers, at least one, not {values!r}.")
    return checked


def _for_each(given: Sequence, values: Sequence[float]) -> Sequence:
    return given if len(given) > 1 else [given[0]] * len(values)


def _check_count(what: str, given: Sequence | None, values: Sequence[float]) -> None:
    if given is not None and len(given) not in (1, len(values)):
        raise ValueError(
            f"{len(given)} {what} do not fit {len(values)} isovalues: give one, or one for each.")


def _checked_part(what: str, given: float) -> float:
    part = finite_number(what, given)
    if part < 0.0:
        raise ValueError(f"{what} must not be negative, but is {given!r}.")
    return part


def _checked_opacities(opacity: float | Sequence[float]) -> list[float]:
    try:
        opacities = [float(opacity)] if isinstance(opacity, (int, float)) else [*map(float, opacity)]
    except (TypeError, ValueError):
        opacities = []
    if not opacities or not all(0.0 <= share <= 1.0 for share in opacities):
        raise ValueError(
            f"The opacity must be a number from 0 to 1, or one for each value, not {opacity!r}.")
    return opacities


def _checked_colors(color: Any) -> list[tuple[float, float, float]]:
    """One colour or several, as three shares each."""
    if not isinstance(color, str) and not hasattr(color, "float_rgb"):
        try:
            parts = list(color)
        except TypeError:
            parts = []
        if parts and not all(isinstance(part, (int, float)) or hasattr(part, "dtype") and
                             part.ndim == 0 for part in parts):
            return [checked_color(part) for part in parts]
    return [checked_color(color)]


def checked_color(color: Any) -> tuple[float, float, float]:
    if hasattr(color, "float_rgb"):
        return tuple(color.float_rgb)  # a pyvista.Color
    if isinstance(color, str):
        named = _named_color(color)
        if named:
            return named
    else:
        try:
            parts = [float(part) for part in color]
        except (TypeError, ValueError):
            parts = []
        # As in PyVista: whole numbers are parts of 255.
        most = 255.0 if parts and all(hasattr(part, "__index__") for part in color) else 1.0
        if len(parts) in (3, 4) and all(0.0 <= part <= most for part in parts):
            return tuple(part / most for part in parts[:3])
    raise ValueError(
        f"There is no colour {color!r}: give a name such as 'tan', '#rrggbb', or red, green and "
        f"blue from 0.0 to 1.0 or as whole numbers to 255.")


def _named_color(name: str) -> tuple[float, float, float] | None:
    colors = vtkNamedColors()
    name = _LETTERS.get(name, name).replace(" ", "").replace("_", "").lower()
    if colors.ColorExists(name):
        return tuple(colors.GetColor3d(name))
    digits = name.lstrip("#")
    if len(digits) in (6, 8) and all(digit in "0123456789abcdef" for digit in digits):
        return tuple(int(digits[i:i + 2], 16) / 255.0 for i in (0, 2, 4))
    return None


def _checked_clim(
    clim: Sequence[float] | None, grid: vtkDataObject, name: str | None, place: str, component: int
) -> tuple[float, float]:
    if clim is None:
        ranges = [array.GetFiniteRange(component) for array in arrays_of(grid, name, place)]
        return min(low for low, _ in ranges), max(high for _, high in ranges)
    try:
        low, high = (float(end) for end in clim)
    except (TypeError, ValueError):
        low, high = math.nan, math.nan
    if not -math.inf < low < high < math.inf:
        raise ValueError(f"clim must be two finite numbers, the smaller one first, not {clim!r}.")
    return low, high


def _color_map(
    cmap: Any, clim: tuple[float, float]
) -> Callable[[float], tuple[float, float, float]]:
    """A function from a value to its colour."""
    if isinstance(cmap, vtkScalarsToColors):
        def look_up(value):
            color = [0.0, 0.0, 0.0]
            cmap.GetColor(value, color)
            return tuple(color)
        return look_up
    if isinstance(cmap, str):
        cmap = _matplotlib_map(cmap)
    elif not callable(cmap):
        colors = _checked_colors(cmap)
        cmap = lambda share: colors[min(int(share * len(colors)), len(colors) - 1)]  # noqa: E731
    low, high = clim
    length = high - low or 1.0
    return lambda value: tuple(
        float(part) for part in cmap(min(max((value - low) / length, 0.0), 1.0))[:3])


def _matplotlib_map(name: str) -> Callable[[float], Sequence[float]]:
    try:
        import matplotlib
    except ImportError:
        raise ImportError(
            f"The colour map {name!r} needs Matplotlib: install it (Debian: python3-matplotlib), or "
            f"give a list of colours or a lookup table.") from None
    try:
        return matplotlib.colormaps[name]
    except KeyError:
        raise ValueError(
            f"Matplotlib has no colour map {name!r}: list(matplotlib.colormaps) tells those it "
            f"has.") from None
