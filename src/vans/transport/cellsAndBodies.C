/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellsAndBodies.H"

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
    source_(matrix.source()),
    inverse_()
{
    addBoundaries();
    factorise();
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


void Foam::cellsAndBodies::factorise()
{
    inverse_ = matrix_.diag() - bodies_.returned();
    const labelUList& l = matrix_.lduAddr().lowerAddr();
    const labelUList& u = matrix_.lduAddr().upperAddr();
    const scalarField& lower = matrix_.lower();
    const scalarField& upper = matrix_.upper();
    forAll(l, facei)
    {
        inverse_[u[facei]] -= lower[facei]*upper[facei]/inverse_[l[facei]];
    }
    inverse_ = 1/inverse_;
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
    result.bodies -= bodies_.received(x.cells, x.bodies);
    return result;
}


Foam::cellsAndBodies::vector Foam::cellsAndBodies::residual
(
    const vector& x
) const
{
    vector result(image(x));
    result.cells = source_ - result.cells;
    result.bodies = bodies_.source() - result.bodies;
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
    bodies_.addToCells(r.bodies/bodies_.diagonal(), z.cells);
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
    z.bodies += bodies_.received(z.cells, scalarField(r.bodies.size(), Zero));
    z.bodies /= bodies_.diagonal();
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

    psi.primitiveFieldRef() = x.cells;
    psi.correctBoundaryConditions();

    // Bodies that exchange nothing among themselves are then exact
    bodies_.values() = x.bodies;
    bodies_.values() =
        (bodies_.source() + bodies_.received(x.cells, x.bodies))
       /bodies_.diagonal();
    return done;
}
