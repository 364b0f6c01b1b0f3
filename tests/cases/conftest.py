# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases that are copied, run and read: tests never write below the checkout."""

import hashlib
import os
import re
import shlex
import shutil
import subprocess
from pathlib import Path
from time import sleep

import grainplot
import foamlib
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]

# Ranks that wait leave their core to the others, and none is bound to a core that another test has
SHARED_CORES = {
    "OMPI_MCA_mpi_yield_when_idle": "1",
    "OMPI_MCA_hwloc_base_binding_policy": "none",
}

# Meshes that blockMesh has made, by what it read: its output, and the files' contents by name
MESHES = {}

# A core that has nothing else left to do waits for no long test when these come first
LONG = ("test_validation.py", "test_tutorials.py")


def pytest_collection_modifyitems(items):
    items.sort(key=lambda item: LONG.index(item.path.name) if item.path.name in LONG else len(LONG))


def pytest_sessionstart():
    os.environ.update(SHARED_CORES)
    os.sched_setaffinity(0, own_cores())
    missing = [name for name in ("blockMesh", "foamDictionary", "mpirun") if not shutil.which(name)]
    if missing or "GRAINFOAM_DIR" not in os.environ:
        pytest.exit(f"run '. etc/bashrc' first (not found: {', '.join(missing) or 'nothing'})", 2)


def own_cores():
    """Cores of this process of pytest, if there are enough for each to have its own.

    A rank that waits and leaves its core to a program of another test gets it back only after that
    program's time slice, a thousand times what it waits for ranks of its own test.
    """
    cores = sorted(os.sched_getaffinity(0))
    count = int(os.environ.get("PYTEST_XDIST_WORKER_COUNT", 1))
    if "PYTEST_XDIST_WORKER" not in os.environ or count > len(cores):
        return cores
    return cores[int(os.environ["PYTEST_XDIST_WORKER"].removeprefix("gw")) :: count]


class Case:
    """A case directory of one's own.

    path   its pathlib.Path
    log    what the last program printed
    """

    def __init__(self, path):
        self.path = path
        self.log = ""
        self._mesh = None

    def run(self, command, check=True, timeout=600):
        """Run a program in the case, a string or a list of words; keep its output in log.<program>.

        Returns the exit code.  With `check`, an exit code other than 0 fails the test and shows
        the end of the output.
        """
        words = shlex.split(command) if isinstance(command, str) else [str(w) for w in command]
        mesh = self._mesh_to_come() if words == ["blockMesh"] else None
        if mesh in MESHES:
            self.log = self._take(mesh)
            return 0
        done = subprocess.run(
            words,
            cwd=self.path,
            env=os.environ | {"PWD": str(self.path)},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=timeout,
        )
        self.log = done.stdout
        with open(self.path / f"log.{_program(words)}", "a") as file:
            file.write(self.log)
        if check and done.returncode != 0:
            end = "\n".join(self.log.splitlines()[-40:])
            pytest.fail(f"{shlex.join(words)}: exit code {done.returncode}\n{end}", pytrace=False)
        if mesh and done.returncode == 0:
            files = sorted((self.path / "constant/polyMesh").iterdir())
            if all(file.is_file() for file in files):
                MESHES[mesh] = self.log, {file.name: file.read_bytes() for file in files}
        return done.returncode

    def _mesh_to_come(self):
        """What blockMesh reads, as one word; None where that is more than two files."""
        read = [self.path / "system" / name for name in ("blockMeshDict", "controlDict")]
        if not all(file.is_file() for file in read):
            return None
        text = b"\0".join(file.read_bytes() for file in read)
        if b"#" in text or b"geometry" in text:
            return None
        return hashlib.sha256(text).hexdigest()

    def _take(self, mesh):
        """Write a mesh that blockMesh has made for another test, as blockMesh would; its output."""
        log, files = MESHES[mesh]
        folder = self.path / "constant/polyMesh"
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        for name, content in files.items():
            (folder / name).write_bytes(content)
        with open(self.path / "log.blockMesh", "a") as file:
            file.write(log)
        return log

    def parallel(self, program, ranks, **options):
        """Run an OpenFOAM program on a case that decomposePar has divided."""
        return self.run(f"mpirun --oversubscribe -np {ranks} {program} -parallel", **options)

    def kill(self, program, time):
        """Run a program and kill it (-9) as soon as it has written a time."""
        process = subprocess.Popen(
            [program],
            cwd=self.path,
            env=os.environ | {"PWD": str(self.path)},
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        while not (self.path / time).exists() and process.poll() is None:
            sleep(0.01)
        process.kill()
        process.wait()

    def dict_set(self, file, entry, value):
        """Set an entry, e.g. ("0/T", "boundaryField/walls/type", "zeroGradient"), or add it."""
        self.run(["foamDictionary", file, "-entry", entry, "-set", str(value)])

    def dict_get(self, file, entry):
        """An entry's value as text."""
        self.run(["foamDictionary", file, "-entry", entry, "-value"])
        return self.log.strip()

    @property
    def times(self):
        """Names of the time directories in ascending order."""
        return grainplot.times(self.path)

    def mesh(self):
        """The cells as polygons, grainplot.PlanarMesh; read again where a file has changed."""
        states = ((file, file.stat()) for file in (self.path / "constant/polyMesh").iterdir())
        state = sorted((str(file), at.st_mtime_ns, at.st_size) for file, at in states)
        if self._mesh is None or self._mesh[0] != state:
            self._mesh = state, grainplot.read_mesh(self.path)
        return self._mesh[1]

    def field(self, name, time=None):
        """Internal values at a time, the last one by default: (n_cells,) or (n_cells, 3)."""
        time = self.times[-1] if time is None else time
        return grainplot.read_field(self.path, time, name, len(self.mesh().polygons))

    def flux(self, patch):
        """Volume that leaves through a patch at the last time [m^3/s]."""
        file = foamlib.FoamFieldFile(self.path / self.times[-1] / "phi")
        return float(np.sum(file.boundary_field[patch].value))

    def grains(self, time=None):
        """Data sets of grains.h5 at a time, the last one by default, sorted by id."""
        data = grainplot.read_grains(self.path, self.times[-1] if time is None else time)
        order = np.argsort(data["id"])
        n = len(order)
        return {k: v[order] if np.ndim(v) and len(v) == n else v for k, v in data.items()}

    def table(self, file):
        """Columns by name; the first line has the names, commas or blanks separate."""
        lines = (self.path / file).read_text().splitlines()
        names = re.split(r"[,\s]+", lines[0].lstrip("# ").strip())
        rows = [re.split(r"[,\s]+", line.strip()) for line in lines[1:] if line.strip()]
        values = np.array([row for row in rows if not row[0].startswith("#")], dtype=float)
        return dict(zip(names, values.reshape(-1, len(names)).T, strict=True))

    def logged(self, pattern):
        """The numbers that follow a text in the last output, e.g. "Courant Number mean: "."""
        number = r"([-+]?[0-9.]+(?:e[-+]?[0-9]+)?)"
        return np.array([float(m) for m in re.findall(re.escape(pattern) + number, self.log)])


def _program(words):
    """The program that counts: not mpirun and its options."""
    if words[0] == "mpirun":
        words = words[words.index("-np") + 2 :]
    return Path(words[0]).name


@pytest.fixture
def clone(tmp_path, request):
    """clone("box2D") copies the case beside the test, clone("tutorials/...") one of the checkout.

    The copy is a Case; 0.orig, if there is one, is copied to 0.  Results of earlier runs are left
    behind.
    """

    def results(folder, names):
        return {
            name
            for name in names
            if re.fullmatch(r"(processor\d+|postProcessing|VTK|log\..*|dynamicCode)", name)
            or (re.fullmatch(r"[0-9.]+(e-?\d+)?", name) and (Path(folder) / name).is_dir())
        }

    def make(template, name=None):
        source = request.path.parent / template
        if not source.is_dir():
            source = ROOT / template
        path = tmp_path / (name or source.name)
        shutil.copytree(source, path, ignore=results)
        if (path / "0.orig").is_dir():
            shutil.copytree(path / "0.orig", path / "0")
        return Case(path)

    return make
