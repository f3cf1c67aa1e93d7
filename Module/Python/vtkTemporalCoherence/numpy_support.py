# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""NumPy arrays in and out: volumes from arrays, pictures and what is known of their pixels.

    image = numpy_to_image(array, spacing=(0.5, 0.5, 2.0))   # shares the array's memory
    mapper.SetInputData(image)
    picture = render(volume, size=(640, 480))                # neither window nor display
    picture.color.shape, picture.depth.shape                 # (480, 640, 4), (480, 640)
    write_png("picture.png", picture.color)

Row 0 of a picture is its bottom row, as everywhere in VTK: plane[y, x] belongs to the pixel of
mapper.PickPixel(x, y, ...). The view plane[::-1] begins with the top row, as Pillow and Matplotlib
want it.
"""

from __future__ import annotations

import operator
import os
import warnings
from typing import BinaryIO, Iterable, NamedTuple, Sequence

try:
    import numpy
except ImportError as error:
    raise ImportError("NumPy is missing: install it (Debian: python3-numpy).") from error
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_INT_MAX, VTK_SIGNED_CHAR, VTK_STRING
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkVolume

from .vtkTemporalCoherence import vtkTemporalCoherenceVolumeMapper

__all__ = ["Planes", "numpy_to_image", "planes", "render", "write_png"]


class Planes(NamedTuple):
    """What a frame knows of its pixels, an array for each plane; None for one not asked for.

    color            (height, width, 4) uint8: RGBA, the colours multiplied by alpha; alpha is 0
                     where nothing is hit
    depth            (height, width) float32: distance along the pixel's ray in world units, from
                     the eye or, in a parallel projection, from the plane through the camera;
                     infinity where nothing is hit
    normals          (height, width, 3) float32: unit normals in the world, facing the viewer; 0
                     where nothing is hit
    isovalue_index   (height, width) int32: position of the isovalue in
                     vtkVolumeProperty.GetIsoSurfaceValues(); -1 where nothing is hit
    answer           (height, width) uint8: whether the pixel's ray was a definite miss (0), a
                     definite hit (1) or a possible hit (2) when the picture was made

    Row 0 is the bottom row. The arrays belong to the caller: they stay as they are when the mapper
    makes another frame or is deleted.
    """

    color: numpy.ndarray | None = None
    depth: numpy.ndarray | None = None
    normals: numpy.ndarray | None = None
    isovalue_index: numpy.ndarray | None = None
    answer: numpy.ndarray | None = None


#: The arrays of a frame that the planes are, each as a bit of FrameArrays and a name.
_FRAME_ARRAYS = {
    "color": (vtkTemporalCoherenceVolumeMapper.FRAME_COLOR, "Color"),
    "depth": (vtkTemporalCoherenceVolumeMapper.FRAME_DEPTH, "Depth"),
    "normals": (vtkTemporalCoherenceVolumeMapper.FRAME_NORMALS, "Normals"),
    "isovalue_index": (vtkTemporalCoherenceVolumeMapper.FRAME_ISOVALUE_INDEX, "IsovalueIndex"),
    "answer": (vtkTemporalCoherenceVolumeMapper.FRAME_ANSWER, "Answer"),
}


def numpy_to_image(
    array: numpy.ndarray,
    spacing: Sequence[float] = (1.0, 1.0, 1.0),
    origin: Sequence[float] = (0.0, 0.0, 0.0),
    name: str = "scalars",
) -> vtkImageData:
    """Make an image whose point scalars are an array.

    array    (nz, ny, nx), or (nz, ny, nx, components): VTK's x runs fastest, as in the arrays of
             SimpleITK. Of an array that is indexed [x, y, z] give array.T.
    spacing  distance of samples, and
    origin   place of the sample [0, 0, 0], both in the order x, y, z and in world units
    name     name of the scalars

    The image shares the array's memory, and keeps it, if the array is C-contiguous and its numbers
    are such as VTK has; else it gets a copy: of bool as uint8, of float16 as float32. When you have
    written to the array, call image.GetPointData().GetScalars().Modified().

    Raises TypeError if these are no real numbers of at most 64 bits in an array without a mask,
    ValueError if they do not lie along three axes.
    """
    if not isinstance(array, numpy.ndarray):
        raise TypeError(
            f"A volume must be a NumPy array, not {type(array).__name__}: use numpy.asarray().")
    if isinstance(array, numpy.ma.MaskedArray):
        raise TypeError(
            "A volume must not be a masked array: give array.filled(value), for floats with NaN, "
            "which is below every isovalue.")
    if array.ndim not in (3, 4) or array.size == 0:
        raise ValueError(
            f"A volume must have the shape (nz, ny, nx) or (nz, ny, nx, components), not "
            f"{array.shape}: reshape the array.")
    image = _image(array, array.shape[2::-1], array.shape[3:], name)
    image.SetSpacing(spacing)
    image.SetOrigin(origin)
    return image


def planes(
    mapper: vtkTemporalCoherenceVolumeMapper, names: Iterable[str] = Planes._fields
) -> Planes:
    """Get the last frame of a mapper, whether it was made for a window or by render().

    names    which planes, or which one; the others are None

    Where an ImageSampleDistance other than 1 gives a window fewer rays than pixels, or more, arrays
    have a value for each ray.

    Raises TypeError for what is no such mapper, ValueError if there is no frame or no such plane.
    """
    _check_mapper(mapper)
    names = set(_checked_names(names))
    frame = vtkImageData()
    with _Told(mapper) as told:
        is_done = mapper.GetLastFrame(frame, sum(_FRAME_ARRAYS[name][0] for name in names))
    told.give_up_unless(
        is_done, "The mapper has made no frame yet: call render() or Render() first.")
    return Planes(**{name: _plane(frame, _FRAME_ARRAYS[name][1]) for name in names})


def render(
    volume: vtkVolume,
    renderer: vtkRenderer | None = None,
    size: tuple[int, int] = (512, 512),
    names: Iterable[str] = Planes._fields,
) -> Planes:
    """Make a picture of a volume without a window, a display or OpenGL.

    volume    its mapper must be a vtkTemporalCoherenceVolumeMapper
    renderer  gives camera and lights. None: one that looks at the whole volume along the z axis
    size      width and height in pixels
    names     which planes are wanted, or which one; the others are None

    The mapper re-uses the last picture of the same renderer, camera and volume: keep the renderer
    for a series of pictures. One that has no camera yet is made to look at the whole volume.

    Raises TypeError for what is no volume with such a mapper, ValueError with the mapper's own
    message if it cannot make the picture, or if there is no such plane. The mapper's warnings are
    UserWarnings of the module warnings.
    """
    if not isinstance(volume, vtkVolume):
        raise TypeError(f"render() draws a vtkVolume, not {type(volume).__name__}.")
    mapper = volume.GetMapper()
    _check_mapper(mapper)
    names = _checked_names(names)
    if renderer is not None and not isinstance(renderer, vtkRenderer):
        raise TypeError(
            f"render() takes camera and lights from a vtkRenderer, not "
            f"{type(renderer).__name__}: give one, or None.")
    width, height = checked_size(size)
    with _Told(mapper) as told:
        renderer = renderer or vtkRenderer()
        if not renderer.IsActiveCameraCreated():
            renderer.ResetCamera(volume.GetBounds())
        is_done = mapper.MakeImage(renderer, volume, width, height, None, None)
    told.give_up_unless(is_done, "The picture was stopped before it was complete: call it again.")
    return planes(mapper, names)


def write_png(
    file: str | os.PathLike | BinaryIO,
    color: numpy.ndarray,
    background: Sequence[float] | None = (0.0, 0.0, 0.0),
) -> None:
    """Write the plane `color` of a picture as PNG.

    file        a path that ends in .png, or an object with write(bytes)
    color       (height, width, 4) uint8, as from render(): the row written last is row 0
    background  red, green and blue, 0 to 1, of what is seen where the surfaces are not opaque.
                None: the PNG is transparent there

    Raises TypeError for another array or what is no file, ValueError for an empty array, another
    suffix or a background that is no colour, OSError if the file cannot be written.
    """
    check_file(file)
    if not isinstance(color, numpy.ndarray):
        raise TypeError(
            f"A picture must be a NumPy array, not {type(color).__name__}: give the plane color of "
            f"render().")
    if color.dtype != numpy.uint8 or color.ndim != 3 or color.shape[2] != 4:
        raise TypeError(
            f"A picture must be uint8 of the shape (height, width, 4), not {color.dtype} of "
            f"{color.shape}: give the plane color of render().")
    if color.size == 0:
        # libpng ends the process for such a picture.
        raise ValueError(
            f"A picture of the shape {color.shape} has no pixels: give one of at least 1 x 1.")
    pixels = straight_alpha(color) if background is None else _before(color, background)

    writer = vtkPNGWriter()
    writer.SetInputData(_image(pixels, (*pixels.shape[1::-1], 1), pixels.shape[2:], "Color"))
    writer.WriteToMemoryOn()
    writer.Write()
    data = memoryview(writer.GetResult())
    if hasattr(file, "write"):
        file.write(data)
    else:
        with open(file, "wb") as opened:
            opened.write(data)


def _before(color: numpy.ndarray, background: Sequence[float]) -> numpy.ndarray:
    """The colours of a picture before a background."""
    behind = (255 - color[..., 3:]) * numpy.asarray(checked_background(background), numpy.float32)
    return numpy.rint(color[..., :3] + behind).astype(numpy.uint8)


def check_file(file: str | os.PathLike | BinaryIO) -> None:
    """For other modules of this package, too: can a PNG be written to this?"""
    if hasattr(file, "write"):
        return
    if not isinstance(file, (str, bytes, os.PathLike)):
        raise TypeError(
            f"A picture is written to a path or to an object with write(bytes), not to "
            f"{type(file).__name__}.")
    if not os.fsdecode(file).lower().endswith(".png"):
        raise ValueError(
            f"Pictures are written as PNG: give a name that ends in .png, not {os.fsdecode(file)!r}.")


def checked_background(background: Sequence[float]) -> Sequence[float]:
    """For other modules of this package, too."""
    try:
        is_color = all(0.0 <= part <= 1.0 for part in background) and len(background) == 3
    except TypeError:
        is_color = False
    if not is_color:
        raise ValueError(
            f"The background must be three numbers from 0 to 1, not {background!r}: give red, "
            f"green and blue.")
    return background


def checked_size(size: tuple[int, int]) -> tuple[int, int]:
    """For other modules of this package, too."""
    try:
        width, height = (operator.index(pixels) for pixels in size)
    except (TypeError, ValueError):
        raise TypeError(
            f"The size must be two whole numbers (width, height), not {size!r}.") from None
    if max(abs(width), abs(height)) > VTK_INT_MAX:
        raise ValueError(f"A picture of {width} x {height} pixels is too large: ask for fewer.")
    return width, height


def straight_alpha(color: numpy.ndarray) -> numpy.ndarray:
    """A copy of RGBA whose colours are no longer multiplied by alpha. For other modules of this
    package, too."""
    alpha = color[..., 3:].astype(numpy.float32)
    straight = color.copy()
    straight[..., :3] = numpy.rint(numpy.minimum(
        255.0 * color[..., :3] / numpy.maximum(alpha, 1.0), 255.0)).astype(numpy.uint8)
    return straight


class _Told:
    """Hears what a mapper says, which would be printed otherwise, while it is entered. Its warnings
    become those of Python."""

    def __init__(self, mapper: vtkTemporalCoherenceVolumeMapper) -> None:
        self._mapper = mapper
        self._warnings: list[str] = []

    def __enter__(self) -> _Told:
        @calldata_type(VTK_STRING)
        def hear_error(mapper, _event, text):
            mapper.last_error = _sentence(text)

        @calldata_type(VTK_STRING)
        def hear_warning(_mapper, _event, text):
            self._warnings.append(_sentence(text))

        self._observers = (
            self._mapper.AddObserver("ErrorEvent", hear_error),
            self._mapper.AddObserver("WarningEvent", hear_warning))
        return self

    def __exit__(self, *_) -> None:
        for observer in self._observers:
            self._mapper.RemoveObserver(observer)
        for warning in self._warnings:
            warnings.warn(warning, stacklevel=3)

    def give_up_unless(self, is_done: bool, otherwise: str) -> None:
        """Raise the mapper's error, or else the given sentence, where something is not done."""
        if is_done:
            self._mapper.last_error = None
        else:
            # A mistake that is repeated is told once, so the sentence may be from an earlier call.
            raise ValueError(getattr(self._mapper, "last_error", None) or otherwise)


def _sentence(text: str) -> str:
    """What is said by "ERROR: In FILE, line NUMBER", and in the next line "CLASS (ADDRESS): SENTENCE"."""
    return text.partition("): ")[2].strip() or text.strip()


def _check_mapper(mapper) -> None:
    if not isinstance(mapper, vtkTemporalCoherenceVolumeMapper):
        raise TypeError(
            f"The mapper must be a vtkTemporalCoherenceVolumeMapper, not {type(mapper).__name__}: "
            f"set one with volume.SetMapper().")


def _checked_names(names: Iterable[str]) -> tuple[str, ...]:
    try:
        names = (names,) if isinstance(names, str) else tuple(names)
    except TypeError:
        raise TypeError(
            f"The planes must be given by their names, not by {names!r}: choose of "
            f"{', '.join(Planes._fields)}.") from None
    for name in names:
        if name not in Planes._fields:
            raise ValueError(f"There is no plane {name!r}, only {', '.join(Planes._fields)}.")
    return names


def data_array(array: numpy.ndarray, components: tuple[int, ...], name: str) -> vtkDataArray:
    """Numbers as an array of VTK that shares their memory, where that can be, and keeps it.

    The shape of a tuple is `components`; all other axes are rows of tuples. For other modules of
    this package.
    """
    numbers = numpy.ascontiguousarray(array, _vtk_dtype(array.dtype)).reshape(-1, *components)
    # VTK's char has a sign on some machines only.
    vtk_type = VTK_SIGNED_CHAR if numbers.dtype == numpy.int8 else None
    vtk_array = numpy_to_vtk(numbers, array_type=vtk_type)
    # The NumPy array has to live as long as the VTK array, so the latter is given an observer that
    # holds it. Python attributes, as numpy_to_vtk uses, outlive the VTK array until VTK's wrappers
    # happen to tidy up, and with them what may be a very large volume.
    vtk_array.AddObserver("UserEvent", lambda *_: numbers)
    vars(vtk_array).pop("_numpy_reference", None)
    vtk_array.SetName(name)
    return vtk_array


def _image(
    array: numpy.ndarray, dimensions: Sequence[int], components: tuple[int, ...], name: str
) -> vtkImageData:
    image = vtkImageData()
    image.SetDimensions(dimensions)
    image.GetPointData().SetScalars(data_array(array, components, name))
    return image


def _vtk_dtype(dtype: numpy.dtype) -> numpy.dtype:
    """The type among VTK's that holds all numbers of a type."""
    if dtype.kind == "b":
        return numpy.dtype(numpy.uint8)
    if dtype.kind == "f" and dtype.itemsize == 2:
        return numpy.dtype(numpy.float32)
    if dtype.kind not in "iuf" or dtype.itemsize > 8:
        raise TypeError(
            f"A volume must hold real numbers of at most 64 bits, not {dtype}: convert it, for "
            f"example by array.astype(numpy.float32).")
    return dtype.newbyteorder("=")


def _plane(frame: vtkImageData, name: str) -> numpy.ndarray:
    """An array of a frame as rows, in the memory of the VTK array, which they keep."""
    width, height, _ = frame.GetDimensions()
    values = vtk_to_numpy(frame.GetPointData().GetArray(name))
    return values.reshape(height, width, *values.shape[1:])
