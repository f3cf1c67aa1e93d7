# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Volumes that show themselves: in notebooks, in files, and in a window."""

from __future__ import annotations

import ctypes
import io
import math
import os
import sys
from typing import TYPE_CHECKING, Any, BinaryIO, Sequence

from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor

from .given_data import leaves
from .vtkTemporalCoherence import vtkTemporalCoherenceRefiner, vtkTemporalCoherenceVolume

if TYPE_CHECKING:  # without NumPy
    import numpy
    from .numpy_support import Planes

#: From where each view looks, and what is up, by PyVista's names.
_VIEWS = {
    "iso": ((1.0, 1.0, 1.0), (0.0, 0.0, 1.0)),
    "xy": ((0.0, 0.0, 1.0), (0.0, 1.0, 0.0)), "yx": ((0.0, 0.0, -1.0), (1.0, 0.0, 0.0)),
    "xz": ((0.0, -1.0, 0.0), (0.0, 0.0, 1.0)), "zx": ((0.0, 1.0, 0.0), (1.0, 0.0, 0.0)),
    "yz": ((1.0, 0.0, 0.0), (0.0, 0.0, 1.0)), "zy": ((-1.0, 0.0, 0.0), (0.0, 1.0, 0.0)),
}

#: Directions of a smaller part across z count as along z: then y is up.
_ALONG = 0.05


class Picture:
    """A finished picture: arrays whose row 0 is the top row, as Matplotlib and Pillow want them.

    color           (height, width, 4) uint8: RGBA, not multiplied by alpha
    depth           (height, width) float32: distance along a pixel's ray in world units; infinity
                    where nothing is seen
    normals         (height, width, 3) float32: unit normals of surfaces in the world; 0 elsewhere
    isovalue_index  (height, width) int32: which isovalue is hit; -1 where none is
    planes          what render() gives: row 0 is the bottom row, and colours are multiplied

    The last expression of a notebook's cell shows it.
    """

    def __init__(self, planes: Planes) -> None:
        self.planes = planes

    @property
    def color(self) -> numpy.ndarray:
        from .numpy_support import straight_alpha
        return straight_alpha(self.planes.color)[::-1]

    @property
    def depth(self) -> numpy.ndarray:
        return self.planes.depth[::-1]

    @property
    def normals(self) -> numpy.ndarray:
        return self.planes.normals[::-1]

    @property
    def isovalue_index(self) -> numpy.ndarray:
        return self.planes.isovalue_index[::-1]

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in pixels."""
        height, width = self.planes.depth.shape
        return width, height

    def save(
        self, file: str | os.PathLike | BinaryIO, background: Sequence[float] | None = None
    ) -> None:
        """Write a PNG.

        file        a path that ends in .png, or an object with write(bytes)
        background  red, green and blue, 0 to 1. None: transparent where nothing is hit

        Raises TypeError for what is no file, ValueError for another suffix or what is no colour,
        OSError if the file cannot be written.
        """
        from .numpy_support import write_png
        write_png(file, self.planes.color, background)

    def _repr_png_(self) -> bytes:
        data = io.BytesIO()
        self.save(data)
        return data.getvalue()

    def __repr__(self) -> str:
        width, height = self.size
        return f"<Picture of {width} x {height} pixels>"


class PicturedVolume(vtkTemporalCoherenceVolume):
    """What isosurface(), composite() and maximum() make: a volume that shows itself.

    It is a vtkVolume for plotters of PyVista and renderers of VTK. Alone, it is a picture: the last
    expression of a notebook's cell shows it.

    `renderer` has the camera and the lights of its pictures.
    """

    _renderer: vtkRenderer | None = None

    @property
    def renderer(self) -> vtkRenderer:
        """Has the camera and the lights of pictures: change them as you like."""
        if self._renderer is None:
            self._renderer = vtkRenderer()
            self._look(self._renderer, "iso")
        return self._renderer

    def look_from(self, view: str | Sequence[float]) -> None:
        """Turn the camera of pictures, so that it sees the whole volume.

        view    "iso", "xy", "xz", "yz" or their reverse, as in PyVista; or the direction from the
                volume to the eye, as three numbers

        Raises ValueError for another view.
        """
        self._look(self.renderer, view)

    def _look(self, renderer: vtkRenderer, view: str | Sequence[float]) -> None:
        direction, up = _view(view)
        camera = renderer.GetActiveCamera()
        camera.SetFocalPoint(0.0, 0.0, 0.0)
        camera.SetPosition(*direction)
        camera.SetViewUp(*up)
        renderer.ResetCamera(self.GetBounds())

    def picture(self, size: tuple[int, int] = (512, 512)) -> Picture:
        """Make a picture, without a window or display. It is final: antialiased, with all light.

        size    width and height in pixels

        The camera's clipping range is set, so that nothing is cut. The view angle is that of the
        shorter side of the picture.

        Raises TypeError for what is no size, ValueError with the mapper's own message if it cannot
        draw the data.
        """
        from .numpy_support import checked_size, render
        width, height = checked_size(size)
        camera = self.renderer.GetActiveCamera()
        is_horizontal = camera.GetUseHorizontalViewAngle()
        camera.SetUseHorizontalViewAngle(width < height)
        self.renderer.ResetCameraClippingRange(self.GetBounds())
        try:
            return Picture(render(self, self.renderer, (width, height)))
        finally:
            camera.SetUseHorizontalViewAngle(is_horizontal)

    def save(
        self, file: str | os.PathLike | BinaryIO, size: tuple[int, int] = (1024, 1024),
        background: Sequence[float] | None = None,
    ) -> None:
        """Write a picture as PNG: see Picture.save()."""
        from .numpy_support import check_file
        check_file(file)
        self.picture(size).save(file, background)

    def data_changed(self) -> None:
        """Tell that numbers were written into the array: the next picture shows them."""
        for leaf in leaves(self.GetMapper().GetInputDataObject(0, 0)):
            for attributes in (leaf.GetPointData(), leaf.GetCellData()):
                for index in range(attributes.GetNumberOfArrays()):
                    attributes.GetAbstractArray(index).Modified()

    def show(
        self, size: tuple[int, int] = (800, 800), background: Sequence[float] = (1.0, 1.0, 1.0)
    ) -> None:
        """Show the volume in a window, to be turned by the mouse, until the window is closed.

        size        width and height in pixels
        background  red, green and blue, 0 to 1

        Pictures have the window's last camera from then on.

        Raises RuntimeError where no display answers, TypeError and ValueError for other arguments.
        """
        from .numpy_support import checked_background, checked_size
        width, height = checked_size(size)
        background = checked_background(background)
        _check_display()
        renderer = vtkRenderer()
        renderer.SetBackground(*background)
        renderer.SetActiveCamera(self.renderer.GetActiveCamera())
        for light in self.renderer.GetLights():
            renderer.AddLight(light)
        renderer.AddVolume(self)
        window = vtkRenderWindow()
        window.SetSize(width, height)
        window.AddRenderer(renderer)
        window.SetWindowName("vtkTemporalCoherence")
        interactor = vtkRenderWindowInteractor()
        interactor.SetRenderWindow(window)
        interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
        refiner = vtkTemporalCoherenceRefiner()
        refiner.SetInteractor(interactor)
        interactor.Initialize()
        renderer.ResetCameraClippingRange()
        window.Render()
        interactor.Start()
        refiner.SetInteractor(None)
        window.Finalize()

    def _repr_png_(self) -> bytes:
        return self.picture()._repr_png_()

    def __repr__(self) -> str:
        low = ", ".join(f"{end:g}" for end in self.GetBounds()[::2])
        high = ", ".join(f"{end:g}" for end in self.GetBounds()[1::2])
        return f"<{type(self).__name__} from ({low}) to ({high})>"


def _check_display() -> None:
    """VTK ends the process where no X server answers."""
    if not sys.platform.startswith("linux"):
        return
    if not os.environ.get("DISPLAY"):
        raise RuntimeError("There is no display for a window: use save() or picture().")
    try:
        x11 = ctypes.CDLL("libX11.so.6")
    except OSError:
        return  # so VTK does not ask an X server, either
    x11.XOpenDisplay.argtypes, x11.XOpenDisplay.restype = [ctypes.c_char_p], ctypes.c_void_p
    x11.XCloseDisplay.argtypes = [ctypes.c_void_p]
    display = x11.XOpenDisplay(None)
    if not display:
        raise RuntimeError(
            f"No display answers at DISPLAY={os.environ['DISPLAY']!r}: correct that, or use save() or "
            f"picture().")
    x11.XCloseDisplay(display)


def _view(view: Any) -> tuple[Sequence[float], Sequence[float]]:
    if isinstance(view, str):
        if view not in _VIEWS:
            raise ValueError(f"There is no view {view!r}, only {', '.join(_VIEWS)}.")
        return _VIEWS[view]
    try:
        x, y, z = (float(part) for part in view)
    except (TypeError, ValueError):
        x, y, z = 0.0, 0.0, 0.0
    largest = max(abs(x), abs(y), abs(z))
    if not 0.0 < largest < math.inf:
        raise ValueError(
            f"A view must be one of {', '.join(_VIEWS)}, or three numbers that are not all 0, not "
            f"{view!r}.")
    direction = (x / largest, y / largest, z / largest)
    is_along_z = math.hypot(direction[0], direction[1]) < _ALONG
    return direction, (0.0, 1.0, 0.0) if is_along_z else (0.0, 0.0, 1.0)
