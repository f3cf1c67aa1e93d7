# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A copy of the repository in which mutants are built, so that nobody's sources are touched."""

import pathlib
import shutil
import subprocess

import suite


class Tree:
    """The copy and its build."""

    def __init__(self, repository, place, jobs):
        self.repository = repository
        self.copy = place / "tree"
        self.build = self.copy / "build"
        self.jobs = jobs
        self.module = self.copy / "vtkTemporalCoherence"

    def update(self):
        """Make the copy equal to the repository, as it lies there: files that are equal keep their
        time, so that they are not built again."""
        listing = subprocess.run(
            ["git", "-c", f"safe.directory={self.repository}", "ls-files", "-z", "--cached",
             "--others", "--exclude-standard"],
            cwd=self.repository, check=True, capture_output=True, text=True).stdout
        names = {name for name in listing.split("\0") if (self.repository / name).is_file()}
        for name in names:
            source, target = self.repository / name, self.copy / name
            if not target.is_file() or target.read_bytes() != source.read_bytes():
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(source, target)
                shutil.copymode(source, target)
        for file in self.copy.rglob("*"):
            name = file.relative_to(self.copy)
            if file.is_file() and name.parts[0] != "build" and str(name) not in names:
                file.unlink()

    def configure(self):
        if not (self.build / "build.ninja").exists():
            subprocess.run(
                ["cmake", "-S", str(self.copy), "-B", str(self.build), "-G", "Ninja",
                 "-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=ON",
                 "-DTEMPORAL_COHERENCE_BUILD_BENCHMARKS=OFF"],
                check=True, stdout=subprocess.DEVNULL)

    def make(self, target):
        """Build a target. What the compiler says where it refuses, else nothing."""
        done = subprocess.run(
            ["ninja", "-C", str(self.build), f"-j{self.jobs}", target], stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, errors="replace", check=False)
        return "" if done.returncode == 0 else done.stdout or "ninja failed"

    def read(self, file):
        return (self.repository / "vtkTemporalCoherence" / file).read_text()

    def sources(self, folders=("Engine", "Vtk")):
        """The engine and what lies between it and VTK."""
        module = self.repository / "vtkTemporalCoherence"
        return [str(path.relative_to(module)) for folder in folders
                for path in sorted((module / folder).rglob("*")) if path.suffix in (".h", ".cxx")]

    def plant(self, mutant):
        """Change a file, and let the standard library check the indices in it: one that leaves its
        array is noticed then, not only what comes of it."""
        checks = "#define _GLIBCXX_ASSERTIONS 1\n" if mutant.file.endswith(".cxx") else ""
        (self.module / mutant.file).write_text(checks + mutant.apply(self.read(mutant.file)))

    def restore(self, mutant):
        (self.module / mutant.file).write_text(self.read(mutant.file))

    def tests(self):
        """The programs' tests. They are there once the build is."""
        for program in (suite.ENGINE, suite.MAPPER):
            if refusal := self.make(program):
                raise RuntimeError(f"{program} does not build:\n{refusal[-4000:]}")
        return suite.find_engine_tests(self.build), suite.find_mapper_tests(self.build)
