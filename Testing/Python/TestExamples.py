# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""The examples run without a display, show what they should, and refuse in one sentence."""

import concurrent.futures
import contextlib
import glob
import http.client
import itertools
import os
import re
import signal
import socket
import struct
import subprocess
import unittest

import numpy
from example import EXAMPLES, PROGRAMS, Example, read_png
from spheres import SAMPLES, distances, image_of
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkStructuredGrid
from vtkmodules.vtkIOXML import vtkXMLStructuredGridWriter


def middle(pixels):
    """Where in a picture the surface is, as shares of its width and height."""
    y, x = numpy.nonzero(pixels.any(axis=2))
    return x.mean() / pixels.shape[1], y.mean() / pixels.shape[0]


class DropIn(Example):
    def test_picture(self):
        self.assertEqual(self.run_well("drop_in.py"), "")
        pixels = read_png(path=self.folder / "drop_in.png")
        self.assertEqual(pixels.shape, (512, 512, 3))
        share = pixels.any(axis=2).mean()
        self.assertTrue(0.1 < share < 0.9, share)
        self.assertGreater(len(numpy.unique(pixels)), 50)

    def test_has_12_lines(self):
        lines = (EXAMPLES / "drop_in.py").read_text(encoding="utf-8").splitlines()
        self.assertEqual(len([line for line in lines if line and not line.startswith("#")]), 12)


class Depth(Example):
    def test_picture(self):
        said = self.run_well(
            "depth.py", self.save_sphere(), "--isovalue", 0.5, "--size", "100x80", "--output", "a.png")
        self.assertEqual(said, "saved as a.png\n")
        pixels = read_png(path=self.folder / "a.png")
        self.assertEqual(pixels.shape, (80, 100, 3))
        self.assertTrue(0.05 < pixels.any(axis=2).mean() < 0.5)

    def test_mistakes(self):
        self.assert_refused("another --output", "depth.py", "--output", "missing/a.png", "--size", "9x9")
        self.assert_refused("outside of the volume.s values", "depth.py", "--isovalue", 1e9, "--output", "a.png")


class ThresholdSweep(Example):
    def test_pictures_and_reuse(self):
        said = self.run_well(
            "threshold_sweep.py", self.save_sphere(), "--from", 0.3, "--to", 0.7, "--frames", 5,
            "--size", "300x200", "--output", "frames")
        for frame, isovalue in enumerate((0.3, 0.4, 0.5, 0.6, 0.7)):
            pixels = read_png(path=self.folder / "frames" / f"frame-{frame:04}.png")
            self.assertEqual(pixels.shape, (200, 300, 3))
            self.assert_shows_sphere(pixels, isovalue)
        self.assertEqual(len(glob.glob(str(self.folder / "frames" / "*"))), 5)
        self.assertEqual(
            re.findall(r"^ +\d +(\S+) +(\w+) +[\d.]+$", said, re.MULTILINE),
            [("0.3", "Cold"), ("0.4", "IsomapBuild"), ("0.5", "IsomapLookup"),
             ("0.6", "IsomapLookup"), ("0.7", "IsomapLookup")])
        self.assertRegex(said, r"IsomapLookup +3 frames, median +[\d.]+ ms\nsaved as frames\n$")

    def test_downwards(self):
        said = self.run_well(
            "threshold_sweep.py", "--from", 200, "--to", 100, "--frames", 3, "--size", "64x64",
            "--output", "frames")
        self.assertEqual(
            re.findall(r"Cold|Isomap\w+", said)[:3], ["Cold", "IsomapBuild", "IsomapLookup"])

    def test_theora(self):
        self.run_well("threshold_sweep.py", "--frames", 3, "--size", "101x67", "--output", "a.ogv")
        data = (self.folder / "a.ogv").read_bytes()
        self.assertTrue(data.startswith(b"OggS") and b"theora" in data[:200])
        self.assertGreater(len(data), 2000)

    def test_gif(self):
        try:
            from PIL import Image
        except ImportError:
            self.skipTest("Pillow is not there (Debian: python3-pil).")
        self.run_well(
            "threshold_sweep.py", self.save_sphere(), "--from", 0.3, "--to", 0.7, "--frames", 3,
            "--size", "200x200", "--output", "a.gif")
        with Image.open(self.folder / "a.gif") as animation:
            self.assertEqual(animation.n_frames, 3)
            for frame, isovalue in enumerate((0.3, 0.5, 0.7)):
                animation.seek(frame)
                self.assert_shows_sphere(numpy.asarray(animation.convert("RGB")), isovalue)

        self.run_well(
            "threshold_sweep.py", self.save_sphere((0.0, 0.0, 0.5)), "--frames", 2, "--from", 0.7,
            "--to", 0.8, "--output", "upper.gif")
        with Image.open(self.folder / "upper.gif") as animation:
            # Pillow's row 0 is the top one, and z points up.
            self.assertLess(middle(numpy.asarray(animation.convert("RGB")))[1], 0.45)

    def test_gif_without_pillow(self):
        (self.folder / "PIL.py").write_text("raise ImportError\n", encoding="utf-8")
        self.assert_refused(
            "Pillow, which is missing: install it", "threshold_sweep.py", "--output", "a.gif",
            PYTHONPATH=os.pathsep.join([str(self.folder), os.environ["PYTHONPATH"]]))

    def test_mistakes(self):
        for words, arguments in (
                ("'a.mp4'|'.mp4' are not written here", ["--output", "a.mp4"]),
                ("cannot be written", ["--output", "/nowhere/a.ogv"]),
                ("cannot be written", ["--output", "/proc/nowhere"]),
                ("Isovalue 300 is outside .* from 0 to 2", ["--to", "300"]),
                ("Isovalue nan is outside", ["--from", "nan"]),
                ("--frames: '1' is no whole number from 2 to 1000000", ["--frames", "1"]),
                ("--frames: '9{20}' is no whole number from 2", ["--frames", "9" * 20]),
                ("--rate: '0' is no whole number from 1 to 100", ["--rate", "0"]),
                ("--rate: '101' is no whole number from 1 to 100", ["--rate", "101"]),
                ("--size: '0x10' is no size", ["--size", "0x10"]),
                ("--size: 'big' is no size", ["--size", "big"]),
                ("invalid float value", ["--from", "much"]),
                ("Azimuth inf is no angle: give degrees", ["--azimuth", "inf"]),
                ("unrecognized arguments: --sise", ["--sise", "3"])):
            self.assert_refused(words, "threshold_sweep.py", *arguments)

    def test_a_frame_cannot_be_written(self):
        (self.folder / "frames" / "frame-0000.png").mkdir(parents=True)
        self.assert_refused(
            "'frames' cannot be written .*: choose another --output", "threshold_sweep.py",
            self.save_sphere(), "--output", "frames", "--frames", 2, "--size", "20x10")

    def test_nobody_reads_what_is_printed(self):
        command = self.command(
            "threshold_sweep.py", self.save_sphere(), "--frames", 2, "--size", "20x10")
        reader, writer = os.pipe()
        os.close(reader)
        done = subprocess.run(
            command, cwd=self.folder, stdout=writer, stderr=subprocess.PIPE, text=True, check=False)
        os.close(writer)
        self.assertEqual((done.returncode, done.stderr), (1, ""))


class Film(Example):
    """README's moving picture is made again."""

    def test_drag_and_turn(self):
        try:
            from PIL import Image
        except ImportError:
            self.skipTest("Pillow is not there (Debian: python3-pil).")
        program = EXAMPLES.parents[1] / "Documentation" / "film.py"
        if not program.exists():
            self.skipTest("The documentation is not there.")
        self.run_well(
            program, self.save_sphere(), "--from", 0.3, "--to", 0.7, "--frames", 4, "--size", 80,
            "--output", "film.webp")
        with Image.open(self.folder / "film.webp") as animation:
            self.assertEqual((animation.n_frames, animation.size), (8, (80, 80)))
            drawn = []
            for frame in range(8):
                animation.seek(frame)
                drawn.append(int((numpy.asarray(animation.convert("L"))[20:] < 250).sum()))
        self.assertGreater(drawn[0], 1.5 * drawn[2])  # a smaller sphere
        self.assertGreater(min(drawn), 100)


class MeshSweep(Example):
    def test_scattered_points(self):
        said = self.run_well(
            "mesh_sweep.py", "--points", 400, "--frames", 4, "--size", "120x90", "--output", "a.png")
        pixels = read_png(path=self.folder / "a.png")
        self.assertEqual(pixels.shape, (90, 120, 3))
        self.assertTrue(0.1 < pixels.any(axis=2).mean() < 0.9)
        rows = re.findall(r"^ +\d +\S+ +(\w+) +[\d.]+ +[\d.]+ +(\d+)$", said, re.MULTILINE)
        self.assertEqual([route for route, _ in rows], [
            "Cold", "IsomapBuild", "IsomapLookup", "IsomapLookup"])
        self.assertGreater(int(rows[0][1]), 100)

    def save_sphere_as_grid(self, scalars):
        grid = vtkStructuredGrid()
        grid.SetDimensions(SAMPLES, SAMPLES, SAMPLES)
        axis = numpy.arange(SAMPLES, dtype=float)
        z, y, x = numpy.meshgrid(axis, axis, axis, indexing="ij")
        points = numpy.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
        grid.SetPoints(vtkPoints())
        grid.GetPoints().SetData(numpy_to_vtk(points, deep=1))
        scalars.SetName("distance")
        grid.GetPointData().AddArray(scalars)
        self.write(vtkXMLStructuredGridWriter(), grid, "sphere.vts")

    def assert_draws_grid(self):
        self.run_well(
            "mesh_sweep.py", "sphere.vts", "--from", 0.4, "--to", 0.5, "--frames", 2, "--azimuth", 0,
            "--size", "200x200", "--output", "a.png")
        self.assert_shows_sphere(read_png(path=self.folder / "a.png"), 0.5)

    def test_files(self):
        self.save_sphere_as_grid(image_of(distances()).GetPointData().GetScalars())
        self.assert_draws_grid()

    def test_vectors(self):
        """Of which vtkContourFilter takes none."""
        values = distances().ravel()
        self.save_sphere_as_grid(
            numpy_to_vtk(numpy.stack([values, 0.0 * values, 1.0 - values], axis=1), deep=1))
        self.assert_draws_grid()

    def test_wrong_cells(self):
        grid = vtkStructuredGrid()
        grid.SetDimensions(3, 3, 3)
        points = vtkPoints()
        for point in range(27):
            points.InsertNextPoint(point % 3, point // 3 % 3, point // 9)
        points.SetPoint(13, float("nan"), 1.0, 1.0)
        grid.SetPoints(points)
        grid.GetPointData().SetScalars(numpy_to_vtk(numpy.arange(27.0), deep=1))
        grid.GetPointData().GetScalars().SetName("number")
        self.write(vtkXMLStructuredGridWriter(), grid, "nowhere.vts")
        self.assert_refused(r"has the point 13 at \(nan, 1, 1\)", "mesh_sweep.py", "nowhere.vts")

    def test_mistakes(self):
        (self.folder / "broken.vtu").write_text("This is no XML.")
        (self.folder / "notes.txt").write_text("This is no mesh.")
        for words, arguments in (
                ("could not be read", ["broken.vtu"]),
                ("could not be read", ["missing.vts"]),
                ("none of .vtu, .vts", ["notes.txt"]),
                ("Isovalue 900 is outside", ["--points", "50", "--from", "900"])):
            self.assert_refused(words, "mesh_sweep.py", *arguments)


class RenderServer(Example):
    @contextlib.contextmanager
    def server(self, *arguments):
        """A server that runs; its port."""
        # Shells have what they start in the background ignore Ctrl+C.
        process = subprocess.Popen(
            self.command("render_server.py", *arguments, "--serve", 0), cwd=self.folder,
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
        try:
            said = process.stdout.readline()
            match = re.fullmatch(r"Serving http://127.0.0.1:(\d+)/ until Ctrl\+C\n", said)
            self.assertTrue(match, said)
            yield int(match[1])
        finally:
            process.send_signal(signal.SIGINT)
            _, complaints = process.communicate(timeout=120)
        self.assertEqual((process.returncode, complaints), (0, ""))

    def get(self, port, address, status=200):
        connection = http.client.HTTPConnection("127.0.0.1", port, timeout=120)
        with contextlib.closing(connection):
            connection.request("GET", address)
            answer = connection.getresponse()
            body = answer.read()
        self.assertEqual(answer.status, status, body[:200])
        route = (answer.getheader("Server-Timing") or "").partition(";dur=")[0]
        return body, answer.getheader("Content-Type"), route

    def test_pictures(self):
        said = self.run_well(
            "render_server.py", "--isovalue", 0.3, "--isovalue", 0.6, "--azimuth", 0, "--azimuth",
            90, "--size", 150, "--output", "a/b", self.save_sphere())
        self.assertEqual(len(said.splitlines()), 4)
        for isovalue in (0.3, 0.6):
            for azimuth in (0, 90):
                path = self.folder / "a" / "b" / f"isovalue{isovalue}_azimuth{azimuth}.png"
                self.assert_shows_sphere(read_png(path=path), isovalue)

    def test_z_is_up_and_azimuth_0_looks_along_y(self):
        self.run_well(
            "render_server.py", self.save_sphere((0.4, 0.0, 0.5)), "--isovalue", 0.7,
            "--azimuth", 0, "--azimuth", 90, "--azimuth", 180)
        for azimuth, side in ((0, 1), (90, 0), (180, -1)):
            x, y = middle(
                read_png(path=self.folder / "pictures" / f"isovalue0.7_azimuth{azimuth}.png"))
            self.assertGreater(y, 0.55)
            self.assertEqual(int(x > 0.55) - int(x < 0.45), side)

    def test_serves_and_reuses(self):
        with self.server(self.save_sphere()) as port:
            page, content_type, _ = self.get(port, "/")
            self.assertTrue(content_type.startswith("text/html"))
            self.assertIn(b'type="range"', page)

            routes = []
            for isovalue in (0.5, 0.5, 0.499, 0.5, 0.499):
                png, content_type, route = self.get(
                    port, f"/picture.png?isovalue={isovalue}&azimuth=0&size=200")
                self.assertEqual(content_type, "image/png")
                self.assert_shows_sphere(read_png(png), isovalue)
                routes.append(route)
            self.assertEqual(routes[:3], ["Cold", "Redisplay", "IsomapBuild"])
            # How soon all of the picture is looked up depends on the speed of the machine.
            self.assertIn(routes[-1], ("IsomapBuild", "IsomapLookup"))
            turned, _, route = self.get(port, "/picture.png?isovalue=0.499&azimuth=2&size=200")
            self.assertEqual(route, "Cold")
            self.assert_shows_sphere(read_png(turned), 0.499)
            self.assertEqual(read_png(self.get(port, "/picture.png")[0]).shape, (512, 512, 3))

    def test_bad_requests(self):
        with self.server() as port:
            for words, query in (
                    ("'much' is no number: give one", "isovalue=much"),
                    ("'' is no number", "isovalue="),
                    ("Isovalue 900 is outside .*: choose one from 0 to", "isovalue=900"),
                    ("Isovalue nan is outside", "isovalue=nan"),
                    ("Azimuth inf is no angle: give degrees", "azimuth=inf"),
                    ("Size 0 .*choose one from 1 to 2048 pixels", "size=0"),
                    ("Size 4096 is not possible", "size=4096"),
                    ("'1e2' is no number", "size=1e2"),
                    ("no parameter 'isovlue': give isovalue", "isovlue=3")):
                body, content_type, _ = self.get(port, "/picture.png?" + query, status=400)
                self.assertRegex(body.decode(), words)
                self.assertEqual(body.count(b"\n"), 1)
                self.assertTrue(content_type.startswith("text/plain"))
            self.get(port, "/secrets", status=404)
            with socket.create_connection(("127.0.0.1", port)) as connection:
                connection.sendall(b"Hello?\r\n\r\n")
                answer = b"".join(iter(lambda: connection.recv(1000), b""))
                self.assertRegex(answer, rb"Bad request .*\.\n$")
            self.assertGreater(len(self.get(port, "/picture.png?size=64")[0]), 500)

    def test_several_callers_at_once(self):
        with self.server(self.save_sphere()) as port:
            # A browser's connection that asks for nothing holds nobody up, and one that does not
            # wait for the answer does no harm.
            idle = socket.create_connection(("127.0.0.1", port))
            for _ in range(3):
                with socket.create_connection(("127.0.0.1", port)) as gone:
                    reset = struct.pack("ii", 1, 0)
                    gone.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, reset)
                    gone.sendall(b"GET /picture.png?size=1000 HTTP/1.0\r\n\r\n")
            isovalues = [0.3, 0.4, 0.5, 0.6] * 3
            with concurrent.futures.ThreadPoolExecutor(4) as callers:
                pictures = callers.map(
                    lambda isovalue: self.get(
                        port, f"/picture.png?isovalue={isovalue}&size=100")[0], isovalues)
                for isovalue, png in zip(isovalues, pictures):
                    self.assert_shows_sphere(read_png(png), isovalue)
            idle.close()

    def test_mistakes(self):
        with self.server() as port:
            self.assert_refused(
                f"Port {port} .*: choose another", "render_server.py", "--serve", port)
        (self.folder / "file").touch()
        for words, arguments in (
                ("Isovalue 900 is outside", ["--isovalue", "30", "--isovalue", "900"]),
                ("Size 4096 is not possible: choose", ["--size", "4096"]),
                ("Azimuth nan is no angle: give degrees", ["--azimuth", "nan"]),
                ("--serve: 'http' is no whole number", ["--serve", "http"]),
                ("cannot be listened at", ["--serve", "70000"]),
                ("cannot be listened at", ["--serve", "0", "--host", "256.0.0.1"]),
                ("'file/a' cannot be written", ["--output", "file/a"])):
            self.assert_refused(words, "render_server.py", *arguments)


class MissingPackages(Example):
    def test_are_named(self):
        paths = os.pathsep.join([str(self.folder), os.environ["PYTHONPATH"]])
        for name, program in itertools.product(("numpy", "vtkTemporalCoherence"), PROGRAMS):
            stub = self.folder / (name + ".py")
            stub.write_text(f"raise ImportError('There is no {name}')\n", encoding="utf-8")
            self.assert_refused(
                f"There is no {name}: install .*python3-numpy .*python3-vtktemporalcoherence",
                program, PYTHONPATH=paths)
            stub.unlink()


class Help(Example):
    def test_tells_of_every_option(self):
        for program in PROGRAMS:
            said = self.run_well(program, "--help")
            for option in ("--array", "--time-step", "--size", "--azimuth", "--output"):
                self.assertIn(option, said)


if __name__ == "__main__":
    unittest.main()
