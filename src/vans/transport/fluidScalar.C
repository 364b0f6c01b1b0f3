/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidScalar.H"

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
    const word& name,
    const dictionary& dict
)
:
    D_
    (
        "D",
        dimViscosity,
        dictionaryInput::getScalarOrDefault(dict, "D", dimViscosity, 0, 0)
    ),
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
    unaccounted_(0)
{
    dictionaryInput::checkKeywords(dict, {"D"});
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


void Foam::fluidScalar::carry
(
    const transportFlux& flux,
    const scalarField& given
)
{
    const fvMesh& mesh = T_.mesh();
    const scalar deltaT = mesh.time().deltaTValue();
    const surfaceScalarField& F = flux.flux();
    const surfaceScalarField conductance
    (
        "conductance", D_*fvc::interpolate(flux.fraction())
    );

    const fvScalarMatrix transport
    (
        fvm::div(F, T_, "div(" + F.name() + ',' + T_.name() + ')')
      - fvm::laplacian(conductance, T_, "laplacian(D," + T_.name() + ')')
    );
    const auto leaving = [&]()
    {
        return scalarField((transport & T_)().primitiveField()*mesh.V().field());
    };
    const scalarField atBeginning((1 - endShare_)*leaving());
    const scalarField& oldVolume = flux.oldVolume();
    const scalarField source(flux.source()*mesh.V().field());
    scalarField gained((1 - endShare_)*source*T_.primitiveField());
    if (given.size())
    {
        gained += given*mesh.V().field();
    }

    fvScalarMatrix TEqn(dimensionedScalar("endShare", dimless, endShare_)*transport);
    TEqn.diag() += flux.volume()/deltaT - endShare_*source;
    TEqn.source() +=
        oldVolume/deltaT*T_.primitiveField() + gained - atBeginning;

    unaccounted_ = -gSum(oldVolume*T_.primitiveField());
    TEqn.solve(mesh.solverDict(T_.name()));

    unaccounted_ +=
        integral(flux)
      + deltaT
       *gSum
        (
            endShare_*(leaving() - source*T_.primitiveField())
          + atBeginning - gained
        );
}
