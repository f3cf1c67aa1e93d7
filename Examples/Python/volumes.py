# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the examples share: volumes from files, and a generated one."""

from __future__ import annotations

import argparse
import contextlib
import math
import os
import pathlib
import sys
import tempfile
import warnings
from typing import Callable, Iterator

from mistakes import UserError, printable, quoted, shortened
from trial import require_bytes, try_reading

try:
    import numpy
    from vtkmodules.vtkCommonCore import vtkDataArray, vtkOutputWindow, vtkStringOutputWindow
    from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkDataSetAttributes, vtkImageData
    from vtkmodules.vtkIOImage import vtkMetaImageReader, vtkNIFTIImageReader, vtkSLCReader
    from vtkmodules.vtkIOLegacy import vtkDataReader, vtkStructuredPointsReader
    from vtkmodules.vtkIOXML import vtkXMLImageDataReader
    from drawn import Drawn
    from medical import apply_header, choose_time_step, require_known_type
    from whole import require_whole
    from vtkTemporalCoherence import numpy_to_image
except ImportError as missing:
    sys.exit(
        f"{pathlib.Path(sys.argv[0]).name}: {missing}: install Debian's python3-numpy and the "
        f"package python3-vtktemporalcoherence, and use /usr/bin/python3.")

READERS = {
    ".vti": vtkXMLImageDataReader,
    ".vtk": vtkStructuredPointsReader,
    ".mhd": vtkMetaImageReader,
    ".mha": vtkMetaImageReader,
    ".nii": vtkNIFTIImageReader,
    ".nii.gz": vtkNIFTIImageReader,
    ".slc": vtkSLCReader,
}
SUFFIXES = ", ".join([".npy", *READERS])
MOST_SAID = 1 << 16  # bytes of what libraries write on the terminal


def add_volume_arguments(arguments: argparse.ArgumentParser) -> None:
    arguments.add_argument(
        "volume", nargs="?",
        help=f"a file {SUFFIXES} (an array [z, y, x]); default: four generated spheres")
    arguments.add_argument("--array", help="the array to draw, of points or cells; default: the file's scalars")
    arguments.add_argument(
        "--time-step", type=number_from(1), default=1, metavar="N",
        help="which volume of a NIfTI that has several; default: 1")


def number_from(least: int, most: int = 1000000) -> Callable[[str], int]:
    """A type of argument: whole numbers, none below the least or above the most."""
    def convert(text: str) -> int:
        if not text.isdecimal() or not least <= int(text) <= most:
            raise argparse.ArgumentTypeError(f"{quoted(text)} is no whole number from {least} to {most}")
        return int(text)
    return convert


def size_of(text: str) -> tuple[int, int]:
    """A type of argument: width and height in pixels."""
    parts = text.split("x")
    if len(parts) != 2 or not all(part.isdecimal() and 0 < int(part) < 16384 for part in parts):
        raise argparse.ArgumentTypeError(f"{quoted(text)} is no size as 640x480, at most 16383x16383")
    return int(parts[0]), int(parts[1])


def volume_of(arguments: argparse.Namespace) -> vtkImageData:
    """The volume that a command line asks for."""
    if arguments.volume is None:
        image = make_spheres(128)
    else:
        image = read_volume(arguments.volume, arguments.time_step)
    choose_array(image, arguments.array, name_of(arguments))
    return image


def name_of(arguments: argparse.Namespace) -> str:
    """What messages call the volume."""
    return "The generated volume" if arguments.volume is None else quoted(arguments.volume)


def make_spheres(samples: int) -> vtkImageData:
    """Four spheres that grow together: 255 in their centres, 0 outside, samples^3 bytes."""
    centres = [(-0.4, -0.4, -0.2), (0.45, -0.3, 0.3), (-0.3, 0.45, 0.35), (0.35, 0.4, -0.4)]
    radius = 0.6
    axis = numpy.linspace(-1.0, 1.0, samples, dtype=numpy.float32)
    z, y, x = axis[:, None, None], axis[:, None], axis
    nearest = numpy.sqrt(numpy.min(
        [(x - cx) ** 2 + (y - cy) ** 2 + (z - cz) ** 2 for cx, cy, cz in centres], axis=0))
    values = 255.0 * numpy.clip(1.0 - nearest / radius, 0.0, 1.0)
    return numpy_to_image(values.astype(numpy.uint8))


def read_volume(path: str, time_step: int = 1) -> vtkImageData:
    if not os.path.exists(path):
        raise UserError(f"There is no file {quoted(path)}: check the path.")
    if not os.path.isfile(path):
        raise UserError(f"{quoted(path)} could not be read: it is no file.")
    if not os.access(path, os.R_OK):
        raise UserError(f"{quoted(path)} may not be read by you: change its permissions.")
    if path.lower().endswith(".npy"):
        return _read_array(path)
    suffix = next((suffix for suffix in READERS if path.lower().endswith(suffix)), None)
    if suffix is None:
        raise UserError(f"The suffix of {quoted(path)} is none of {SUFFIXES}: convert the volume.")
    try_reading(path, lambda: _read_untried(path, suffix, time_step))
    return _read_untried(path, suffix, time_step)


def _read_untried(path: str, suffix: str, time_step: int) -> vtkImageData:
    """A reader may end the program here."""
    if suffix in (".mhd", ".mha"):
        require_known_type(path)
    reader = READERS[suffix]()
    reader.SetFileName(path)
    if suffix == ".vtk":
        read_all_arrays(reader)
    if suffix.startswith(".nii"):
        reader.SetTimeAsVector(time_step > 1)
    with errors_of_vtk() as errors:
        remark = require_whole(path, reader)
        reader.Update()
    image = reader.GetOutput()
    # Only the reader of legacy files tells by a warning that a file ends too early.
    if errors(suffix == ".vtk") or image.GetNumberOfPoints() == 0:
        raise UserError(
            f"{quoted(path)} could not be read as an image: check that it is a whole file of the format "
            f"that its suffix tells.")
    require_bytes(path, 1024 * image.GetActualMemorySize())
    choose_time_step(reader, path, image, time_step)
    apply_header(reader, path, image)
    if remark:
        print(remark)
    return image


def read_all_arrays(reader: vtkDataReader) -> None:
    """Of legacy files VTK reads the first array of each kind by default."""
    for kind in ("Scalars", "Vectors", "Normals", "Tensors", "ColorScalars", "TCoords", "Fields"):
        getattr(reader, f"ReadAll{kind}On")()


def drawn_scalars(data: vtkDataSet) -> vtkDataArray | None:
    """What the mapper draws of its own accord: scalars of the points, or else of the cells."""
    return data.GetPointData().GetScalars() or data.GetCellData().GetScalars()


def choose_scalars(data: vtkDataSet, name: str | None, what: str) -> None:
    """Make an array what is drawn: the named one, else the scalars, else the first one that varies."""
    arrays, drawn = {}, Drawn(data)

    def varies(name: str) -> bool:
        attributes, _, array = arrays[name]
        low, high = drawn.range(array, attributes is data.GetCellData())
        return low < high

    for attributes, count in (
            (data.GetPointData(), data.GetNumberOfPoints()), (data.GetCellData(), data.GetNumberOfCells())):
        for index in range(attributes.GetNumberOfArrays()):
            array = attributes.GetArray(index)  # some are no numbers, and some have no name
            if array and not array.IsA("vtkBitArray") and array.GetNumberOfTuples() == count and \
                    attributes.GetArrayName(index) != vtkDataSetAttributes.GhostArrayName():
                arrays.setdefault(attributes.GetArrayName(index) or "", (attributes, index, array))
    if not arrays:
        raise UserError(
            f"{what} has no arrays of numbers, one for each point or cell: check that it is whole, or add "
            f"some.")
    if name is None:
        own = data.GetPointData().GetScalars()
        names = [own.GetName() or ""] if own else []
        names = [name for name in [*names, *arrays] if name in arrays]
        name = next((name for name in names if varies(name)), names[0])
    if name not in arrays:
        there = shortened(printable(", ".join(arrays)))
        raise UserError(f"{what} has no array {quoted(name)}: choose one of {there}.")
    data.GetPointData().SetActiveScalars(None)
    attributes, index, _ = arrays[name]
    attributes.SetActiveAttribute(index, vtkDataSetAttributes.SCALARS)


def choose_array(image: vtkImageData, name: str | None, what: str) -> None:
    """Make an array of a volume what is drawn."""
    if min(image.GetDimensions()) < 2:
        raise UserError(
            f"{what} has {' x '.join(map(str, image.GetDimensions()))} samples: a volume needs at "
            f"least 2 along each axis.")
    choose_scalars(image, name, what)
    _check_place(image, what)


def _check_place(image: vtkImageData, what: str) -> None:
    """The camera is placed by the box of the samples: it must be one that numbers can tell of."""
    largest, farthest, flattest = 1e15, 1e9, 1e-6
    matrix = image.GetIndexToPhysicalMatrix()
    extent = image.GetExtent()
    steps = numpy.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(3)])
    with numpy.errstate(all="ignore"):
        edges = steps[:, :3] * [extent[1] - extent[0], extent[3] - extent[2], extent[5] - extent[4]]
        corner = numpy.linalg.norm(steps[:, 3] + steps[:, :3] @ extent[::2])
        lengths = numpy.linalg.norm(edges, axis=0)
        upright = abs(numpy.linalg.det(edges / lengths)) if numpy.isfinite(edges).all() and \
            lengths.all() else 0.0
    if not (corner <= largest and 1.0 / largest <= lengths.min() and lengths.max() <= largest and
            lengths.min() >= flattest * lengths.max() and upright >= flattest and
            corner <= farthest * lengths.max()):
        raise UserError(
            f"{what} has a spacing, an origin or a direction with which it cannot be seen: correct "
            f"them in its header.")


def value_range(data: vtkDataSet, what: str) -> tuple[float, float]:
    """The least and the greatest number among the scalars that are drawn; an error if there is no surface."""
    low, high = Drawn(data).range(drawn_scalars(data), not data.GetPointData().GetScalars())
    if not math.isfinite(high - low) and low < high:
        raise UserError(
            f"The values of {what}, {low:g} to {high:g}, lie too far apart to choose isovalues between them: scale "
            f"them down.")
    if not low < high:
        attributes = (data.GetPointData(), data.GetCellData())
        names = [of.GetArrayName(index) or "" for of in attributes for index in range(of.GetNumberOfArrays())]
        others = f" by --array ({shortened(printable(', '.join(names)))})" if len(names) > 1 else ""
        raise UserError(
            f"The samples of {what} are all the same or no numbers, so that it has no isosurface: "
            f"choose another volume or array{others}.")
    return low, high


def check_isovalue(isovalue: float, limits: tuple[float, float]) -> None:
    low, high = limits
    if not low <= isovalue <= high:
        raise UserError(
            f"Isovalue {isovalue:g} is outside of the volume's values: choose one from {low:g} to "
            f"{high:g}.")


def _read_array(path: str) -> vtkImageData:
    try:
        # Mapped, not read: what a big array has is loaded when it is looked at.
        with numpy.errstate(all="ignore"), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return numpy_to_image(numpy.load(path, mmap_mode="r"))
    except Exception as error:  # pylint: disable=broad-except # NumPy's are of many kinds
        reason = " ".join(str(error).split()).rstrip(".")
        raise UserError(f"{quoted(path)} could not be read as a NumPy volume: {reason}.") from error


#: What MetaIO says on the terminal of a file that is not whole.
SHORT_FILE = ("not read completely", "Uncompress failed")


def _has_errors(said: str | bytes, on_terminal: str, are_warnings: bool) -> bool:
    # What VTK cites of a file may be no UTF-8.
    text = said.decode("latin-1") if isinstance(said, bytes) else said
    return "ERROR:" in text or (are_warnings and "Generic Warning:" in text) or any(
        words in on_terminal for words in SHORT_FILE)


@contextlib.contextmanager
def errors_of_vtk() -> Iterator[Callable[..., bool]]:
    """Keep VTK and its libraries silent, and tell whether there were errors, or warnings, too."""
    window, before = vtkStringOutputWindow(), vtkOutputWindow.GetInstance()
    vtkOutputWindow.SetInstance(window)
    sys.stdout.flush()
    kept = [os.dup(stream) for stream in (1, 2)]
    on_terminal = ""
    file = tempfile.TemporaryFile()
    try:
        for stream in (1, 2):
            os.dup2(file.fileno(), stream)
        yield lambda are_warnings=False: _has_errors(window.GetOutput(), on_terminal, are_warnings)
    finally:
        for stream, copy in zip((1, 2), kept):
            os.dup2(copy, stream)
            os.close(copy)
        file.seek(0)
        on_terminal = file.read(MOST_SAID).decode("latin-1")
        file.close()
        vtkOutputWindow.SetInstance(before)
