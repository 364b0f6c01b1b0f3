/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidScalar.H"

#include "cellsAndBodies.H"
#include "dictionaryInput.H"
#include "fvCFD.H"

Foam::scalar Foam::fluidScalar::endShare(const fvMesh& mesh, const word& name)
{
    const word keyword("ddt(" + name + ')');
    const dictionary& schemes =
        dictionaryInput::subDict(mesh.schemesDict(), "ddtSchemes");
    if (!schemes.found(keyword))
    {
        return 1;
    }
    const word scheme
    (
        dictionaryInput::getWord(schemes, keyword, {"Euler", "CrankNicolson"})
    );
    return scheme == "Euler" ? 1 : 0.5;
}


Foam::fluidScalar::fluidScalar
(
    const fvMesh& mesh,
    const word& name
)
:
    endShare_(endShare(mesh, name)),
    T_
    (
        IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            IOobject::MUST_READ,
            IOobject::AUTO_WRITE
        ),
        mesh
    ),
    unaccounted_(0),
    carriedOut_(mesh.boundary().size(), Zero),
    diffusedOut_(mesh.boundary().size(), Zero),
    broughtIn_(0)
{
    // Of the flux that transports
    mesh.divScheme("div(phiFluid," + name + ')');
    mesh.solverDict(name);
}


void Foam::fluidScalar::beforeMeshChange(const transportFlux& flux)
{
    // Registered, so that the change of the mesh maps it; one at a time, as there is
    // one name
    content_.clear();
    content_.reset
    (
        new volScalarField
        (
            IOobject
            (
                T_.name() + "Content", T_.time().timeName(), T_.mesh()
            ),
            T_.mesh(),
            T_.dimensions()
        )
    );
    *content_ == flux.fraction()*T_;
}


void Foam::fluidScalar::meshChanged(const transportFlux& flux)
{
    if (T_.mesh().topoChanging())
    {
        T_.primitiveFieldRef() =
            content_().primitiveField()/flux.fraction().primitiveField();
    }
    T_.correctBoundaryConditions();
    content_.clear();
}


Foam::scalar Foam::fluidScalar::integral(const transportFlux& flux) const
{
    return gSum(flux.volume()*T_.primitiveField());
}


Foam::scalar Foam::fluidScalar::magnitude(const transportFlux& flux) const
{
    return gSum(flux.volume()*mag(T_.primitiveField()));
}


void Foam::fluidScalar::addOutflow
(
    const surfaceScalarField& flux,
    const surfaceScalarField& conductivity,
    const scalar share
)
{
    const scalar time = share*T_.time().deltaTValue();
    forAll(carriedOut_, patchi)
    {
        const fvPatchScalarField& T = T_.boundaryField()[patchi];
        if (!T.coupled())
        {
            carriedOut_[patchi] +=
                time*gSum(flux.boundaryField()[patchi]*T);
            diffusedOut_[patchi] -=
                time
               *gSum
                (
                    conductivity.boundaryField()[patchi]
                   *T.patch().magSf()*T.snGrad()
                );
        }
    }
}


void Foam::fluidScalar::carry
(
    const transportFlux& flux,
    const dimensionedScalar& D
)
{
    carry(flux, D*fvc::interpolate(flux.fraction()));
}


void Foam::fluidScalar::carry
(
    const transportFlux& flux,
    const surfaceScalarField& conductivity,
    const cellExchange& exchange,
    bodyExchange* bodies
)
{
    const fvMesh& mesh = T_.mesh();
    const scalarField& V = mesh.V().field();
    const scalar deltaT = mesh.time().deltaTValue();
    const surfaceScalarField& F = flux.flux();

    const fvScalarMatrix transport
    (
        fvm::div(F, T_, "div(" + F.name() + ',' + T_.name() + ')')
      - fvm::laplacian(conductivity, T_, "laplacian(D," + T_.name() + ')')
    );
    const auto leaving = [&]()
    {
        return scalarField((transport & T_)().primitiveField()*V);
    };
    const scalarField atBeginning((1 - endShare_)*leaving());
    carriedOut_ = Zero;
    diffusedOut_ = Zero;
    addOutflow(F, conductivity, 1 - endShare_);

    const scalarField& oldVolume = flux.oldVolume();
    const scalarField source(flux.source()*V);
    scalarField gained((1 - endShare_)*source*T_.primitiveField());
    if (exchange.given.size())
    {
        gained += exchange.given*V;
    }
    scalarField lost(-endShare_*source);
    if (exchange.coefficient.size())
    {
        lost += exchange.coefficient*V;
    }

    fvScalarMatrix TEqn(dimensionedScalar("endShare", dimless, endShare_)*transport);
    TEqn.diag() += flux.volume()/deltaT + lost;
    TEqn.source() +=
        oldVolume/deltaT*T_.primitiveField() + gained - atBeginning;

    unaccounted_ = -gSum(oldVolume*T_.primitiveField());
    broughtIn_ = (1 - endShare_)*gSum(source*T_.primitiveField());
    const dictionary& controls = mesh.solverDict(T_.name());
    const solverPerformance done
    (
        bodies
      ? cellsAndBodies(TEqn, *bodies).solve(controls)
      : TEqn.solve(controls)
    );
    scalarField fromBodies(T_.size(), Zero);
    if (bodies)
    {
        bodies->addToCells(bodies->values(), fromBodies);
    }
    if (!done.converged() && !(done.finalResidual() < 1e-6))
    {
        FatalErrorInFunction
            << "The solution of " << T_.name() << " at time "
            << mesh.time().timeName() << " does not converge: residual "
            << done.finalResidual() << " after " << done.nIterations()
            << " iterations" << nl
            << "    allowed: another solver, or more iterations, of '"
            << T_.name() << "' in system/fvSolution; a run continues from the"
            << " last complete time" << exit(FatalError);
    }

    unaccounted_ +=
        integral(flux)
      + deltaT
       *gSum
        (
            endShare_*leaving() + lost*T_.primitiveField()
          + atBeginning - gained - fromBodies
        );
    addOutflow(F, conductivity, endShare_);
    broughtIn_ += endShare_*gSum(source*T_.primitiveField());
    broughtIn_ *= deltaT;
}
