# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""PyVista's scripts, not changed at all, show what VTK shows; and isosurface() in its plotters.

Each of Scripts/ runs twice, without and with VTK_AUTOLOAD_PATH, in an empty directory. The pictures
that it leaves there are compared.

environment: TEMPORAL_COHERENCE_AUTOLOAD, what VTK_AUTOLOAD_PATH becomes
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy
    import PIL.Image
    import PIL.ImageSequence
    import pyvista
except ImportError as error:
    print(f"SKIPPED: there is no PyVista here (Debian: python3-pyvista): {error}")
    sys.exit()

if "DISPLAY" not in os.environ:
    print("SKIPPED: windows need a display, for example that of xvfb-run.")
    sys.exit()

from vtkTemporalCoherence import isosurface, replace_mapper, use_everywhere

AUTOLOAD_PATH = os.environ["TEMPORAL_COHERENCE_AUTOLOAD"]
SCRIPTS = pathlib.Path(__file__).resolve().parent / "Scripts"
TOLD = "A volume is drawn by vtkTemporalCoherenceVolumeMapper"

#: Of 255, the mean over a picture: VTK's mapper samples rays in steps.
MEAN_DIFFERENCE = 0.75
#: The share of the pixels that differ by more than 16: lines before the volume, steps between voxels.
DIFFERENT = 0.005

#: VTK draws cells of very different sizes in places that are a little wrong, and takes their normals as
#: if they were all of one size. An image with the same field is within 0.06 of 255 of our picture.
MEAN_DIFFERENCES = {"rectilinear_grid.png": 2.5, "rectilinear_shaded.png": 4.0}
DIFFERENTS = {"rectilinear_grid.png": 0.03, "rectilinear_shaded.png": 0.1}

#: PyVista draws meshes by vtkUnstructuredGridVolumeRayCastMapper, which is no mapper of images.
DRAWN_BY_VTK = ("unstructured_grid",)


def pictures_of(folder):
    """For each name of a file, its pictures as RGBA."""
    pictures = {}
    for path in sorted(pathlib.Path(folder).iterdir()):
        if path.suffix in (".png", ".gif"):
            with PIL.Image.open(path) as image:
                pictures[path.name] = [
                    numpy.asarray(frame.convert("RGBA")).astype(int)
                    for frame in PIL.ImageSequence.Iterator(image)]
    return pictures


def run_script(path, **environment):
    """Its pictures, the sizes of its other files, and what was logged."""
    surroundings = {
        name: value for name, value in os.environ.items()
        if not name.startswith(("VTK_AUTOLOAD_PATH", "VTK_TEMPORAL"))}
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [sys.executable, str(path)], cwd=folder, env={**surroundings, **environment},
            check=False, capture_output=True, text=True, timeout=300)
        if done.returncode != 0:
            raise AssertionError(f"{path.name} ended with {done.returncode}: {done.stderr}")
        sizes = {
            file.name: file.stat().st_size for file in pathlib.Path(folder).iterdir()
            if file.suffix not in (".png", ".gif")}
        return pictures_of(folder), sizes, done.stderr


class UnchangedScripts(unittest.TestCase):
    def test_scripts(self):
        scripts = sorted(SCRIPTS.glob("*.py"))
        self.assertGreaterEqual(len(scripts), 10)
        for path in scripts:
            with self.subTest(path.stem):
                self.compare(path)

    def compare(self, path):
        before, sizes_before, told_before = run_script(path)
        # Composites of the nearest voxels, PyVista's default, are left to VTK otherwise.
        after, sizes_after, told = run_script(
            path, VTK_AUTOLOAD_PATH=AUTOLOAD_PATH, VTK_TEMPORAL_COHERENCE_BLEND_VOLUMES="ALWAYS")
        self.assertNotIn("is drawn by", told_before)
        self.assertTrue(before)
        self.assertEqual(before.keys(), after.keys())
        self.assertEqual(sizes_before.keys(), sizes_after.keys())
        for name, size in sizes_before.items():
            self.assertGreater(min(size, sizes_after[name]), 1000, name)
        if path.stem in DRAWN_BY_VTK:
            self.assertNotIn("is drawn by", told)
        else:
            self.assertIn(TOLD, told)
        for name in before:
            self.assertEqual(len(before[name]), len(after[name]), name)
            self.assertGreater(len(numpy.unique(after[name][0].reshape(-1, 4), axis=0)), 50)
            differences = numpy.abs(numpy.array(before[name]) - numpy.array(after[name]))
            different = (differences.max(axis=-1) > 16).mean()
            print(f"{name}: {differences.mean():.3f} of 255, {100 * different:.2f} % of the pixels "
                  f"by more than 16")
            if path.stem in DRAWN_BY_VTK:
                self.assertEqual(differences.max(), 0, name)
            else:
                self.assertLess(
                    differences.mean(), MEAN_DIFFERENCES.get(name, MEAN_DIFFERENCE), name)
                self.assertLess(different, DIFFERENTS.get(name, DIFFERENT), name)
                self.assertTrue(differences.any(), f"{name}: the same mapper drew both pictures")


AXIS = numpy.linspace(-1.0, 1.0, 33)


def with_distances(grid):
    """A grid whose surfaces are spheres around the origin."""
    grid["distance"] = numpy.linalg.norm(grid.points, axis=1)
    return grid


def ball():
    spacing = AXIS[1] - AXIS[0]
    return with_distances(pyvista.ImageData(
        dimensions=(AXIS.size,) * 3, spacing=(spacing,) * 3, origin=(AXIS[0],) * 3))


def halves(image):
    return pyvista.MultiBlock([
        image.extract_subset((0, 16, 0, 32, 0, 32)), image.extract_subset((16, 32, 0, 32, 0, 32))])


def explicit(_):
    # Each cell has corners of its own.
    twice = numpy.repeat(AXIS, 2)[1:-1]
    z, y, x = numpy.meshgrid(twice, twice, twice, indexing="ij")
    corners = numpy.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
    return with_distances(pyvista.ExplicitStructuredGrid((AXIS.size,) * 3, corners))


#: Each kind of PyVista's data, made of the ball.
KINDS = {
    "ImageData": lambda image: image,
    "RectilinearGrid": lambda image: image.cast_to_rectilinear_grid(),
    "StructuredGrid": lambda image: image.cast_to_structured_grid(),
    "ExplicitStructuredGrid": explicit,
    "UnstructuredGrid": lambda image: image.cast_to_unstructured_grid(),
    "tetrahedra": lambda image: image.to_tetrahedra(),
    "MultiBlock": halves,
    "MultiBlock of meshes": lambda image: pyvista.MultiBlock(
        [part.cast_to_unstructured_grid() for part in halves(image)]),
}


class Isosurfaces(unittest.TestCase):
    """isosurface(grid, values) in a plotter is what add_mesh(grid.contour(values)) shows."""

    def setUp(self):
        self.image = ball()

    def picture(self, *fill, size=1.0):
        plotter = pyvista.Plotter(off_screen=True, window_size=(300, 300), lighting="none")
        try:
            plotter.add_light(pyvista.Light(light_type="headlight"))
            plotter.background_color = "black"
            for add in fill:
                add(plotter)
            plotter.camera_position = [
                (3.0 * size, 2.0 * size, 4.0 * size), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
            return plotter.screenshot(return_img=True)[..., :3].astype(int)
        finally:
            plotter.close()

    def contour(self, values, **look):
        mesh = self.image.contour(values, scalars="distance", compute_normals=True)
        return self.picture(lambda plotter: plotter.add_mesh(
            mesh, smooth_shading=True, show_scalar_bar=False, **look))

    def ours(self, grid, values, *scalars, **look):
        self.surface = isosurface(grid, values, *scalars, **look)
        return self.picture(lambda plotter: plotter.add_actor(self.surface))

    def assert_alike(self, before, after, different=0.01):
        self.assertGreater((after.max(axis=-1) > 0).mean(), 0.05)
        differences = numpy.abs(before - after).max(axis=-1)
        self.assertLess((differences > 16).mean(), different)
        self.assertLess(differences.mean(), 2.0)

    def test_kinds_of_data(self):
        before = self.contour([0.6], color="tan")
        for kind, make in KINDS.items():
            with self.subTest(kind):
                self.assert_alike(before, self.ours(
                    make(self.image), 0.6, "distance", color="tan", smooth_shading=True))

    def test_where_scalars_come_from(self):
        before = self.contour([0.6], color="lightblue")
        named = self.ours(self.image, 0.6)
        self.assert_alike(before, named)
        array = numpy.array(self.image["distance"])
        self.assertTrue((self.ours(self.image, 0.6, array) == named).all())
        self.assertEqual(self.image.array_names, ["distance"])
        vectors = pyvista.ImageData(
            dimensions=self.image.dimensions, spacing=self.image.spacing, origin=self.image.origin)
        vectors["vectors"] = numpy.array(vectors.points)
        self.assert_alike(before, self.ours(vectors, 0.6, "vectors"), 0.02)
        cells = self.image.point_data_to_cell_data()
        self.assert_alike(self.ours(cells.cell_data_to_point_data(), 0.6), self.ours(cells, 0.6))

    def test_colors(self):
        for color in ("r", "tan", "#ff8000", "ff8000", [1.0, 0.5, 0.0], (255, 128, 0),
                      pyvista.Color("teal"), numpy.array([0.1, 0.2, 0.3])):
            with self.subTest(color):
                self.assert_alike(
                    self.contour([0.6], color=color), self.ours(self.image, 0.6, color=color))

    def test_color_maps(self):
        values = [0.4, 0.9]
        table = pyvista.LookupTable("plasma", scalar_range=(0.0, 2.0))
        for look in (
                {"cmap": "plasma", "clim": (0.2, 1.5)}, {"cmap": table},
                {"cmap": ["red", "lime", "blue"], "clim": (0.0, 1.0)}):
            with self.subTest(look):
                opacities = [1.0, 0.3]
                self.assert_alike(
                    self.picture(*[
                        lambda plotter, value=value, opacity=opacity: plotter.add_mesh(
                            self.image.contour([value], scalars="distance", compute_normals=True),
                            smooth_shading=True, show_scalar_bar=False, opacity=opacity, **look)
                        for value, opacity in zip(values, opacities)]),
                    self.ours(self.image, values, opacity=opacities, **look), 0.02)

    def test_values_can_be_moved(self):
        moved = isosurface(self.image, 0.4, cmap="viridis")
        moved.values = 0.8
        self.assertEqual(moved.values, (0.8,))
        picture = self.picture(lambda plotter: plotter.add_actor(moved))
        self.assertTrue((picture == self.ours(self.image, 0.8, cmap="viridis")).all())

    def test_replaced_mapper(self):
        def replaced(plotter):
            volume = plotter.add_volume(self.image, shade=True, show_scalar_bar=False)
            # PyVista 0.44 makes bytes of the scalars.
            low, high = volume.mapper.dataset.get_data_range()
            replace_mapper(volume, [low + 0.4 * (high - low)])
        self.assertGreater((self.picture(replaced).max(axis=-1) > 0).mean(), 0.05)

    def test_mappers_of_add_volume(self):
        """Those that ask the factory are drawn by ours; PyVista has Python classes of them."""
        self.addCleanup(use_everywhere, False)
        # "gpu" samples at distances of 1, whatever the size of voxels.
        grid = pyvista.Wavelet()

        def add(plotter, mapper):
            # What is blended of the nearest voxels, PyVista's default, is left to VTK.
            volume = plotter.add_volume(grid, mapper=mapper, blending="maximum", show_scalar_bar=False)
            volume.GetProperty().SetInterpolationTypeToLinear()

        for name, is_ours in (
                ("smart", True), ("gpu", True), ("open_gl", False), ("fixed_point", False)):
            with self.subTest(name):
                pictures = []
                for use in (False, True):
                    use_everywhere(use)
                    pictures.append(self.picture(lambda plotter: add(plotter, name), size=10.0))
                self.assertEqual(bool((pictures[0] != pictures[1]).any()), is_ours)
                self.assertLess(numpy.abs(pictures[0] - pictures[1]).mean(), 4.0)


if __name__ == "__main__":
    unittest.main()
