/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidScalar.H"

#include "cellsAndBodies.H"
#include "dictionaryInput.H"
#include "fluidInput.H"
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
    held_(nullptr),
    unaccounted_(0),
    carriedOut_(mesh.boundary().size(), Zero),
    diffusedOut_(mesh.boundary().size(), Zero),
    broughtIn_(0)
{
    // Of the flux that transports
    const word scheme("div(phiFluid," + name + ')');
    requireDivScheme(mesh, scheme);
    refuseBounded(mesh, scheme);
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
    if (held_)
    {
        content_->primitiveFieldRef() =
            flux.fraction().primitiveField()*content(T_.primitiveField());
    }
}


void Foam::fluidScalar::meshChanged(const transportFlux& flux)
{
    if (T_.mesh().topoChanging())
    {
        T_.primitiveFieldRef() =
            content_().primitiveField()/flux.fraction().primitiveField();
        if (held_)
        {
            T_.primitiveFieldRef() = held_->value(T_.primitiveField());
        }
    }
    T_.correctBoundaryConditions();
    content_.clear();
}


Foam::scalar Foam::fluidScalar::integral(const transportFlux& flux) const
{
    return integral(flux.volume());
}


Foam::scalar Foam::fluidScalar::integral(const scalarField& volume) const
{
    return gSum(volume*content(T_.primitiveField()));
}


Foam::scalarField Foam::fluidScalar::content(const scalarField& T) const
{
    return held_ ? held_->of(T) : T;
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
                time*gSum(flux.boundaryField()[patchi]*content(T));
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


Foam::fvScalarMatrix Foam::fluidScalar::transport
(
    const surfaceScalarField& flux,
    const surfaceScalarField& conductivity
) const
{
    const word& name = T_.name();
    tmp<fvScalarMatrix> carried
    (
        fvm::div(flux, T_, "div(" + flux.name() + ',' + name + ')')
    );
    if (held_)
    {
        held_->transport(carried.ref(), flux, T_);
    }
    return fvScalarMatrix
    (
        carried
      - fvm::laplacian(conductivity, T_, "laplacian(D," + name + ')')
    );
}


void Foam::fluidScalar::solve(fvScalarMatrix& equation, bodyExchange* bodies)
{
    const dictionary& controls = T_.mesh().solverDict(T_.name());
    const solverPerformance done
    (
        bodies
      ? cellsAndBodies(equation, *bodies).solve(controls)
      : equation.solve(controls)
    );
    if (!done.converged() && !(done.finalResidual() < 1e-6))
    {
        FatalErrorInFunction
            << "The solution of " << T_.name() << " at time "
            << T_.time().timeName() << " does not converge: residual "
            << done.finalResidual() << " after " << done.nIterations()
            << " iterations" << nl
            << "    allowed: another solver, or more iterations, of '"
            << T_.name() << "' in system/fvSolution; a run continues from the"
            << " last complete time" << exit(FatalError);
    }
}


void Foam::fluidScalar::carry
(
    const transportFlux& flux,
    const surfaceScalarField& conductivity,
    const cellExchange& exchange,
    bodyExchange* bodies
)
{
    const scalarField& V = T_.mesh().V().field();
    const scalar deltaT = T_.time().deltaTValue();
    const surfaceScalarField& F = flux.flux();

    autoPtr<fvScalarMatrix> leaving
    (
        new fvScalarMatrix(transport(F, conductivity))
    );
    const auto left = [&]()
    {
        return scalarField((*leaving & T_)().primitiveField()*V);
    };
    const scalarField atBeginning((1 - endShare_)*left());
    carriedOut_ = Zero;
    diffusedOut_ = Zero;
    addOutflow(F, conductivity, 1 - endShare_);

    const scalarField before
    (
        flux.oldVolume()*content(T_.primitiveField())
    );
    const scalarField source(flux.source()*V);
    scalarField gained((1 - endShare_)*source*content(T_.primitiveField()));
    if (exchange.given.size())
    {
        gained += exchange.given*V;
    }
    const scalarField holding(flux.volume()/deltaT - endShare_*source);
    scalarField lost(T_.size(), Zero);
    if (exchange.coefficient.size())
    {
        lost = exchange.coefficient*V;
    }
    unaccounted_ = -gSum(before);
    broughtIn_ = (1 - endShare_)*gSum(source*content(T_.primitiveField()));

    // Newton's method; once where the content is the value.  Where it goes to and
    // fro about a peak of the slope, the chord between its last two values
    const label most = held_ ? 100 : 1, mostTangents = 8;
    scalarField lastButOne;
    scalar notLinear = 0;
    for (label i = 0; i < most; ++i)
    {
        if (i > 0)
        {
            leaving.reset(new fvScalarMatrix(transport(F, conductivity)));
        }
        const scalarField last(T_.primitiveField());
        const scalarField H(content(last));
        scalarField c
        (
            held_ ? held_->slope(last) : scalarField(T_.size(), 1)
        );
        if (i >= mostTangents)
        {
            const scalarField change(last - lastButOne);
            const scalarField chord((H - content(lastButOne))/stabilise(change, VSMALL));
            forAll(c, celli)
            {
                if (mag(change[celli]) > 1e-10*mag(last[celli]))
                {
                    c[celli] = max(c[celli], chord[celli]);
                }
            }
        }
        lastButOne = last;
        fvScalarMatrix TEqn
        (
            dimensionedScalar("endShare", dimless, endShare_)*leaving()
        );
        TEqn.diag() += holding*c + lost;
        TEqn.source() += before/deltaT + gained - atBeginning;
        if (held_)
        {
            TEqn.source() -= holding*(H - c*last);
        }
        solve(TEqn, bodies);

        const scalarField& T = T_.primitiveField();
        if (!held_)
        {
            break;
        }
        notLinear = gMax(mag(content(T) - H - c*(T - last))/mag(H));
        if (notLinear < 1e-14)
        {
            break;
        }
    }
    if (notLinear > 1e-9)
    {
        FatalErrorInFunction
            << T_.name() << " whose content is "
            << "not proportional to it was not found in " << most
            << " iterations: " << notLinear << " of the content is left" << nl
            << "    allowed: shorter steps, or a capacity with less of a peak"
            << exit(FatalError);
    }
    scalarField fromBodies(T_.size(), Zero);
    if (bodies)
    {
        bodies->addToCells(bodies->values(), fromBodies);
        unaccounted_ += deltaT*bodies->takenInCells(T_.primitiveField());
    }

    const scalarField H(content(T_.primitiveField()));
    unaccounted_ +=
        gSum(flux.volume()*H)
      + deltaT
       *gSum
        (
            endShare_*left() - endShare_*source*H + lost*T_.primitiveField()
          + atBeginning - gained - fromBodies
        );
    addOutflow(F, conductivity, endShare_);
    broughtIn_ += endShare_*gSum(source*H);
    broughtIn_ *= deltaT;
}
