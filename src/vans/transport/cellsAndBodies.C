/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellsAndBodies.H"

#include "combineOverRanks.H"
#include "volFields.H"

void Foam::cellsAndBodies::vector::add
(
    const scalar factor,
    const vector& other
)
{
    cells += factor*other.cells;
    bodies += factor*other.bodies;
}


Foam::cellsAndBodies::cellsAndBodies
(
    fvScalarMatrix& matrix,
    bodyExchange& bodies
)
:
    matrix_(matrix),
    bodies_(bodies),
    interfaces_(matrix.psi().boundaryField().scalarInterfaces()),
    areInCells_(bodies.isInCells().found(true)),
    bodyOfCells_(bodies.bodyOfCells()),
    source_(matrix.source()),
    inverse_(),
    diagonal_(bodies.diagonal()),
    weight_(diagonal_.size(), 1)
{
    addBoundaries();
    setDiagonal();
    setWeight();
    factorise();
    bodies_.factorise(diagonal_);
}


void Foam::cellsAndBodies::addBoundaries()
{
    forAll(matrix_.internalCoeffs(), patchi)
    {
        const labelUList& cells = matrix_.lduAddr().patchAddr(patchi);
        const scalarField& internal = matrix_.internalCoeffs()[patchi];
        const scalarField& boundary = matrix_.boundaryCoeffs()[patchi];
        const bool coupled =
            matrix_.psi().boundaryField()[patchi].coupled();
        forAll(cells, i)
        {
            matrix_.diag()[cells[i]] += internal[i];
            if (!coupled)
            {
                source_[cells[i]] += boundary[i];
            }
        }
    }
}


void Foam::cellsAndBodies::setDiagonal()
{
    if (!areInCells_)
    {
        return;
    }
    const labelUList& l = matrix_.lduAddr().lowerAddr();
    const labelUList& u = matrix_.lduAddr().upperAddr();
    vector own{matrix_.diag(), scalarField(diagonal_.size(), Zero)};
    forAll(l, facei)
    {
        const label body = bodyOfCells_[l[facei]];
        if (body >= 0 && body == bodyOfCells_[u[facei]])
        {
            own.cells[l[facei]] += matrix_.upper()[facei];
            own.cells[u[facei]] += matrix_.lower()[facei];
        }
    }
    gather(own);
    diagonal_ += own.bodies;
}


void Foam::cellsAndBodies::setWeight()
{
    const vector alike
    {
        scalarField(matrix_.diag().size(), 1), scalarField(diagonal_.size(), 1)
    };
    const scalarField own(image(alike).bodies);
    forAll(weight_, i)
    {
        weight_[i] =
            min(max(1 - own[i]/diagonal_[i], scalar(SMALL)), scalar(1));
    }
}


void Foam::cellsAndBodies::spread(vector& x) const
{
    if (areInCells_)
    {
        forAll(bodyOfCells_, celli)
        {
            if (bodyOfCells_[celli] >= 0)
            {
                x.cells[celli] = x.bodies[bodyOfCells_[celli]];
            }
        }
    }
}


void Foam::cellsAndBodies::gather(vector& r) const
{
    if (!areInCells_)
    {
        return;
    }
    scalarField ofCells(r.bodies.size(), Zero);
    forAll(bodyOfCells_, celli)
    {
        if (bodyOfCells_[celli] >= 0)
        {
            ofCells[bodyOfCells_[celli]] += r.cells[celli];
            r.cells[celli] = 0;
        }
    }
    sumOverRanks(ofCells);
    r.bodies += ofCells;
}


void Foam::cellsAndBodies::factorise()
{
    inverse_ = matrix_.diag() - bodies_.returned();
    const labelUList& l = matrix_.lduAddr().lowerAddr();
    const labelUList& u = matrix_.lduAddr().upperAddr();
    const scalarField& lower = matrix_.lower();
    const scalarField& upper = matrix_.upper();
    const auto isOfBody = [&](const label celli)
    {
        return areInCells_ && bodyOfCells_[celli] >= 0;
    };
    forAll(l, facei)
    {
        if (!isOfBody(l[facei]))
        {
            inverse_[u[facei]] -=
                lower[facei]*upper[facei]/inverse_[l[facei]];
        }
    }
    forAll(inverse_, celli)
    {
        inverse_[celli] = isOfBody(celli) ? 0 : 1/inverse_[celli];
    }
}


Foam::cellsAndBodies::vector Foam::cellsAndBodies::image(const vector& x) const
{
    vector result{scalarField(x.cells.size()), bodies_.diagonal()*x.bodies};
    matrix_.Amul
    (
        result.cells, x.cells, matrix_.boundaryCoeffs(), interfaces_, 0
    );
    scalarField given(x.cells.size(), Zero);
    bodies_.addToCells(x.bodies, given);
    result.cells -= given;
    result.bodies -= bodies_.fromCells(x.cells);
    result.bodies -= bodies_.fromBodies(x.bodies);
    gather(result);
    result.bodies *= weight_;
    return result;
}


Foam::cellsAndBodies::vector Foam::cellsAndBodies::residual
(
    const vector& x
) const
{
    vector result{source_, bodies_.source()};
    gather(result);
    result.bodies *= weight_;
    result.add(-1, image(x));
    return result;
}


Foam::cellsAndBodies::vector Foam::cellsAndBodies::preconditioned
(
    const vector& r
) const
{
    const labelUList& l = matrix_.lduAddr().lowerAddr();
    const labelUList& u = matrix_.lduAddr().upperAddr();
    const scalarField& lower = matrix_.lower();
    const scalarField& upper = matrix_.upper();

    vector z(r);
    z.bodies /= weight_;
    scalarField alone(z.bodies);
    bodies_.solveAlone(alone);
    bodies_.addToCells(alone, z.cells);
    z.cells *= inverse_;
    forAll(l, facei)
    {
        z.cells[u[facei]] -=
            inverse_[u[facei]]*lower[facei]*z.cells[l[facei]];
    }
    forAllReverse(l, facei)
    {
        z.cells[l[facei]] -=
            inverse_[l[facei]]*upper[facei]*z.cells[u[facei]];
    }
    z.bodies += bodies_.fromCells(z.cells);
    bodies_.solveAlone(z.bodies);
    spread(z);
    return z;
}


Foam::scalar Foam::cellsAndBodies::product(const vector& a, const vector& b)
{
    return gSumProd(a.cells, b.cells) + sumProd(a.bodies, b.bodies);
}


Foam::scalar Foam::cellsAndBodies::size(const vector& a)
{
    return gSumMag(a.cells) + sumMag(a.bodies);
}


Foam::scalar Foam::cellsAndBodies::scale(const vector& x) const
{
    const scalar mean = gAverage(x.cells);
    const vector even
    (
        image
        ({
            scalarField(x.cells.size(), mean),
            scalarField(x.bodies.size(), mean)
        })
    );
    vector change(image(x));
    change.add(-1, even);
    vector source{source_, bodies_.source()};
    gather(source);
    source.bodies *= weight_;
    source.add(-1, even);
    return size(change) + size(source) + SMALL;
}


Foam::solverPerformance Foam::cellsAndBodies::solve(const dictionary& controls)
{
    const scalar tolerance = controls.getOrDefault<scalar>("tolerance", 1e-6);
    const scalar relTol = controls.getOrDefault<scalar>("relTol", 0);
    const label maxIter = controls.getOrDefault<label>("maxIter", 1000);
    const label minIter = controls.getOrDefault<label>("minIter", 0);

    auto& psi = const_cast<volScalarField&>(matrix_.psi());
    vector x{psi.primitiveField(), bodies_.values()};
    spread(x);
    vector r(residual(x));
    const scalar norm = scale(x);

    solverPerformance done("cellsAndBodies", psi.name());
    done.initialResidual() = size(r)/norm;
    done.finalResidual() = done.initialResidual();
    const auto isEnough = [&]()
    {
        return
            done.nIterations() >= minIter
         && done.checkConvergence(tolerance, relTol);
    };

    const vector shadow(r);
    vector p(r), v(r);
    scalar rho = 0, alpha = 0, omega = 0;
    while (!isEnough() && done.nIterations() < maxIter)
    {
        const scalar rhoOld = rho;
        rho = product(shadow, r);
        if (done.checkSingularity(mag(rho)))
        {
            break;
        }
        if (done.nIterations() > 0)
        {
            const scalar beta = rho/rhoOld*alpha/omega;
            p.add(-omega, v);
            p.cells *= beta;
            p.bodies *= beta;
            p.add(1, r);
        }
        const vector y(preconditioned(p));
        v = image(y);
        alpha = rho/product(shadow, v);
        x.add(alpha, y);
        r.add(-alpha, v);
        ++done.nIterations();
        done.finalResidual() = size(r)/norm;
        if (isEnough())
        {
            break;
        }
        const vector z(preconditioned(r));
        const vector t(image(z));
        omega = product(t, r)/max(product(t, t), VSMALL);
        x.add(omega, z);
        r.add(-omega, t);
        done.finalResidual() = size(r)/norm;
    }
    if (solverPerformance::debug)
    {
        done.print(Info.masterStream(psi.mesh().comm()));
    }
    psi.mesh().setSolverPerformance(psi.name(), done);

    // Bodies that exchange nothing among themselves are then exact
    x.bodies += residual(x).bodies/weight_/diagonal_;
    spread(x);

    psi.primitiveFieldRef() = x.cells;
    psi.correctBoundaryConditions();
    bodies_.values() = x.bodies;
    return done;
}
