# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""solveContactProblem on FCLIB files made here, its answers judged by a residual of our own."""

import re
import subprocess

import h5py
import numpy as np
import pytest

SOLVERS = ("sweeps", "queue", "nesterov")
WEIGHT = 9.81e-3  # m g dt of a unit mass [N s]


def solve(*words):
    """Run the program; returns exit code, standard output and errors."""
    done = subprocess.run(
        ["solveContactProblem", *map(str, words)], capture_output=True, text=True, timeout=120
    )
    return done.returncode, done.stdout, done.stderr


def grain_contacts(centres, dim):
    """Pairs of unit grains that touch, with normals; partner -1 is the ground."""
    pairs = []
    for j, x in enumerate(centres):
        for i in range(j):
            d = x - centres[i]
            if np.linalg.norm(d) < 2 + 1e-9:
                pairs.append((i, j, d / np.linalg.norm(d)))
        if x[-1] < 1 + 1e-9:
            pairs.append((-1, j, np.eye(dim)[-1]))
    return pairs


def frame(n):
    if len(n) == 2:
        return np.array([n, [-n[1], n[0]]])
    t = np.cross(n, np.eye(3)[np.argmin(np.abs(n))])
    t /= np.linalg.norm(t)
    return np.array([n, t, np.cross(n, t)])


def delassus(centres, velocities):
    """W and q of unit discs or spheres that touch each other and the ground."""
    dim = centres.shape[1]
    turns = 1 if dim == 2 else 3
    pairs = grain_contacts(centres, dim)
    h = np.zeros((len(centres), dim + turns, dim * len(pairs)))
    for k, (i, j, n) in enumerate(pairs):
        f = frame(n)
        for body, sign in ((i, -1), (j, 1)):
            if body < 0:
                continue
            # The arm from the centre to the contact is -sign n
            arm = -sign * n
            spin = (
                f @ np.array([[-arm[1]], [arm[0]]])
                if dim == 2
                else f @ np.array([np.cross(e, arm) for e in np.eye(3)]).T
            )
            columns = slice(dim * k, dim * (k + 1))
            h[body, :dim, columns] = sign * f.T
            h[body, dim:, columns] = sign * spin.T
    inverse_mass = np.r_[np.ones(dim), np.full(turns, 2 if dim == 2 else 2.5)]
    w = np.einsum("bik,i,bil->kl", h, inverse_mass, h)
    motion = np.hstack([velocities, np.zeros((len(centres), turns))])
    return w, np.einsum("bik,bi->k", h, motion)


def heap(dim):
    """Grains in rows, each on those below, that fall and move at random."""
    random = np.random.default_rng(1)
    if dim == 2:
        centres = [(2 * i + row, 1 + np.sqrt(3) * row) for row in range(9) for i in range(9 - row)]
    else:
        centres = [
            (2 * i + row, 2 * j + row, 1 + np.sqrt(2) * row)
            for row in range(4)
            for i in range(5 - row)
            for j in range(5 - row)
        ]
    centres = np.array(centres, dtype=float)
    velocities = WEIGHT * random.uniform(-1, 1, centres.shape)
    velocities[:, -1] -= WEIGHT
    return delassus(centres, velocities)


def write(path, w, q, mu, storage="rows", **more):
    """An FCLIB file; `more` has further data sets by their path."""
    n = len(q)
    row, column = np.nonzero(w.T)[::-1] if storage == "columns" else np.nonzero(w)
    lines = {"rows": row, "columns": column}.get(storage)
    sets = {
        "fclib_local/spacedim": [n // len(mu)],
        "fclib_local/W/m": [n],
        "fclib_local/W/n": [n],
        "fclib_local/W/nzmax": [len(row)],
        "fclib_local/W/nz": [{"rows": -2, "columns": -1}.get(storage, len(row))],
        "fclib_local/W/i": column if storage == "rows" else row,
        "fclib_local/W/p": column if lines is None else np.searchsorted(lines, np.arange(n + 1)),
    }
    with h5py.File(path, "w") as file:
        for name, values in sets.items():
            file[name] = np.asarray(values, dtype=np.int32)
        file["fclib_local/W/x"] = w[row, column]
        file["fclib_local/vectors/q"] = q
        file["fclib_local/vectors/mu"] = mu
        file["fclib_local/info/title"] = np.bytes_("heap")
        for name, values in more.items():
            file[name] = values


def read_solution(path):
    with h5py.File(path) as file:
        return file["solution/u"][()], file["solution/r"][()]


def worst_violation(w, q, mu, r):
    """Of Signorini and Coulomb: W_NN times the change of r that one step of projected gradients,
    of length 1/W_NN, would bring, in m/s; the largest of all contacts."""
    dim = len(q) // len(mu)
    u = (w @ r + q).reshape(-1, dim)
    scale = w.diagonal()[::dim, None]
    x = scale * r.reshape(-1, dim)
    y = x - u
    y[:, 0] -= mu * np.linalg.norm(u[:, 1:], axis=1)
    # Onto the cone: the nearest of its inside, its tip and its side
    tangential = np.linalg.norm(y[:, 1:], axis=1)
    side = np.maximum(0, (y[:, 0] + mu * tangential) / (1 + mu**2))
    inside = tangential <= mu * y[:, 0]
    normal = np.where(inside, y[:, 0], side)
    shrink = np.where(inside, 1, mu * side / np.maximum(tangential, 1e-300))
    projected = np.column_stack([normal, y[:, 1:] * shrink[:, None]])
    return np.linalg.norm(x - projected, axis=1).max()


@pytest.mark.parametrize("dim", [2, 3])
def test_solvers_agree_and_solve(tmp_path, dim):
    w, q = heap(dim)
    # With more friction there are several solutions: packings on a lattice are redundant
    mu = np.linspace(0.05, 0.2, len(q) // dim)
    tolerance = 1e-6 * WEIGHT
    found = {}
    for solver in SOLVERS:
        file = tmp_path / f"{solver}.hdf5"
        write(file, w, q, mu)
        code, out, err = solve(file, "-solver", solver, "-tolerance", tolerance)
        assert (code, err) == (0, "")
        u, r = read_solution(file)
        assert worst_violation(w, q, mu, r) <= tolerance
        assert np.abs(w @ r + q - u).max() <= 1e-12
        found[solver] = u
        # What the program prints is what we find
        rows = re.findall(r"(?:before|after) +(\S+) +(\S+) +(\S+)", out)
        before, after = (float(row[0]) for row in rows)
        assert before == pytest.approx(worst_violation(w, q, mu, 0 * r), rel=1e-4)
        assert after == pytest.approx(worst_violation(w, q, mu, r), rel=1e-4)
        assert f"contacts     {len(mu)} in {dim} dimensions" in out
        assert "mu           0.05 to 0.2" in out
    # There are contacts that open, slide and stick
    slip = np.linalg.norm(found["sweeps"].reshape(-1, dim)[:, 1:], axis=1)
    opening = found["sweeps"].reshape(-1, dim)[:, 0]
    for kind in (opening > 1e-2 * WEIGHT, slip > 1e-2 * WEIGHT, slip < 1e-5 * WEIGHT):
        assert kind.sum() >= 5
    # Errors add up along chains of some ten contacts and back
    assert np.abs(found["queue"] - found["sweeps"]).max() <= 50 * tolerance
    assert np.abs(found["nesterov"] - found["sweeps"]).max() <= 50 * tolerance


@pytest.mark.parametrize("storage", ["rows", "columns", "triplets"])
def test_forms_of_the_matrix(tmp_path, storage):
    # Not symmetric, so that rows and columns must not be exchanged
    w = np.array([[2.0, 0.5], [0.0, 3.0]])
    q = np.array([-1.0, 0.3])
    file = tmp_path / "one.hdf5"
    write(file, w, q, [1.0], storage)
    assert solve(file, "-tolerance", 1e-12)[0] == 0
    u, r = read_solution(file)
    # Sticks
    assert u == pytest.approx([0, 0], abs=1e-12)
    assert r == pytest.approx(-np.linalg.solve(w, q), abs=1e-12)


def test_column_of_discs(tmp_path):
    grains = 20
    centres = np.array([(0, 2 * i + 1) for i in range(grains)], dtype=float)
    w, q = delassus(centres, np.tile([0, -WEIGHT], (grains, 1)))
    file = tmp_path / "column.hdf5"
    write(file, w, q, np.full(grains, 0.3))
    assert solve(file, "-tolerance", 1e-12)[0] == 0
    _, r = read_solution(file)
    # The contact below grain k carries all from it upwards
    assert r[::2] == pytest.approx(WEIGHT * (grains - np.arange(grains)), rel=1e-6)


def test_starts_from_the_guess_and_replaces_the_solution(tmp_path):
    w, q = heap(2)
    mu = np.full(len(q) // 2, 0.3)
    file, other = tmp_path / "heap.hdf5", tmp_path / "other.hdf5"
    write(file, w, q, mu)
    assert solve(file, "-tolerance", 1e-10)[0] == 0
    u, r = read_solution(file)
    before = file.read_bytes()
    guess = {"guesses/number_of_guesses": [1], "guesses/1/r": r, "guesses/1/u": u}
    write(other, w, q, mu, **guess, **{"solution/r": 0 * r, "solution/u": 0 * r})
    code, out, _ = solve(other, "-tolerance", 1e-10)
    assert code == 0
    assert "guess 1" in out
    assert re.search(r"sweeps +0\.0\n", out)
    assert np.array_equal(read_solution(other)[1], r)
    with h5py.File(other) as result:
        assert result["fclib_local/info/title"][()] == b"heap"
    code, _, _ = solve(file, "-output", tmp_path / "new.hdf5")
    assert code == 0
    assert file.read_bytes() == before
    assert np.abs(read_solution(tmp_path / "new.hdf5")[0] - u).max() < 1e-4
    assert sorted(p.name for p in tmp_path.iterdir()) == ["heap.hdf5", "new.hdf5", "other.hdf5"]


@pytest.mark.parametrize("solver", SOLVERS)
def test_says_when_it_has_not_converged(tmp_path, solver):
    w, q = heap(2)
    file = tmp_path / "heap.hdf5"
    write(file, w, q, np.full(len(q) // 2, 0.3))
    before = file.read_bytes()
    code, out, err = solve(file, "-solver", solver, "-maxSweeps", 2)
    assert code == 1
    assert "not converged" in err
    assert "-maxSweeps" in err
    assert "after" in out
    assert file.read_bytes() == before


def test_bad_files_are_refused_by_name(tmp_path):
    w, q = np.eye(2), np.array([-1.0, 0.0])
    cases = {
        "fclib_local/vectors/mu": [[-0.5], [0.1, 0.2], [np.nan]],
        "fclib_local/vectors/q": [[1.0], [np.inf, 0]],
        "fclib_local/W/x": [[1.0], [-1.0, 1.0]],
        "fclib_local/W/i": [[0, 7]],
        "fclib_local/W/nz": [[-7]],
        "fclib_local/spacedim": [[5]],
    }
    for name, values in cases.items():
        for value in [*values, None]:
            file = tmp_path / "bad.hdf5"
            write(file, w, q, [0.3])
            with h5py.File(file, "a") as h5:
                dtype = h5[name].dtype
                del h5[name]
                if value is not None:
                    h5[name] = np.asarray(value, dtype=dtype)
            code, out, err = solve(file)
            assert code == 1
            assert err.startswith(f"solveContactProblem: {file}: ")
            assert name in err or "fclib_local: contact 0" in err, err
    (tmp_path / "text.hdf5").write_text("not HDF5")
    for file in (tmp_path / "text.hdf5", tmp_path / "none.hdf5"):
        code, _, err = solve(file)
        assert code == 1
        assert f"{file}: cannot be opened" in err


@pytest.mark.parametrize(
    "words, said",
    [
        ([], "-help"),
        (["a.hdf5", "b.hdf5"], "b.hdf5"),
        (["a.hdf5", "-solver", "newton"], "sweeps, queue and nesterov"),
        (["a.hdf5", "-tolerance"], "-tolerance"),
        (["a.hdf5", "-tolerance", "small"], "'small'"),
        (["a.hdf5", "-maxSweeps", "1.5"], "'1.5'"),
        (["a.hdf5", "-maxsweeps", "1"], "-maxsweeps"),
    ],
)
def test_wrong_options_are_refused(words, said):
    code, _, err = solve(*words)
    assert code == 1
    assert said in err


def test_tolerance_must_be_positive(tmp_path):
    write(tmp_path / "a.hdf5", np.eye(2), np.array([-1.0, 0.0]), [0.3])
    code, _, err = solve(tmp_path / "a.hdf5", "-tolerance", 0)
    assert code == 1
    assert "tolerance 0" in err


def test_help():
    code, out, _ = solve("-help")
    assert code == 0
    assert "-maxSweeps" in out
