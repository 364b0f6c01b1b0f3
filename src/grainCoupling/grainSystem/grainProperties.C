/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainProperties.H"

#include "cyclicPolyPatch.H"
#include "dictionaryInput.H"
#include "grainWalls.H"

Foam::grainProperties::grainProperties(const fvMesh& mesh, const vector& g)
:
    plane_(mesh),
    dict_
    (
        IOobject
        (
            "grainProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    ),
    g_(g),
    materials_(dict_),
    walls_
    (
        readGrainWalls
        (
            dictionaryInput::subDict(dict_, "walls"), plane_, materials_
        )
    ),
    contact_(readContact()),
    packingRatio_
    (
        dictionaryInput::getScalarOrDefault
        (
            dictionaryInput::subDict(dict_, "coupling"),
            "packingRatio", dimless, 1, 0.1, 1
        )
    ),
    allowedOverlap_
    (
        dictionaryInput::getScalarOrDefault
        (
            dict_, "allowedOverlap", dimless, 0.01, 0
        )
    )
{
    check();
}


void Foam::grainProperties::check() const
{
    dictionaryInput::checkKeywords
    (
        dict_,
        {
            "FoamFile", "shape", "materials", "contactLaws", "walls",
            "initialGrains", "allowedOverlap", "contact", "coupling"
        }
    );
    dictionaryInput::checkKeywords
    (
        coupling(), {"packingRatio", "voidFraction", "drag"}
    );

    for (const polyPatch& patch : plane_.mesh().boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(patch))
        {
            WarningInFunction
                << "Grains do not pass through the cyclic patch "
                << patch.name() << ": one that reaches it leaves the mesh"
                << endl;
        }
    }

    const word shape(dict_.get<word>("shape"));
    if (shape != "disc")
    {
        dictionaryInput::badValue(dict_, "shape", shape, "disc");
    }

    if (mag(plane_.outOfPlane(g_)) > SMALL*mag(g_))
    {
        FatalErrorInFunction
            << "Keyword 'value' of constant/g has a component across the mesh: "
            << g_ << nl << "    allowed: a vector in the plane of the mesh"
            << exit(FatalError);
    }
}


nscd::Settings Foam::grainProperties::readContact() const
{
    const dictionary& dict = dictionaryInput::subDict(dict_, "contact");

    dictionaryInput::checkKeywords
    (
        dict, {"tolerance", "maxSweeps", "maxDisplacement", "blocks"}
    );

    nscd::Settings settings;
    settings.tolerance =
        dictionaryInput::getPositive(dict, "tolerance", dimLength);
    settings.maxSweeps = dictionaryInput::getLabelOrDefault
    (
        dict, "maxSweeps", settings.maxSweeps, 1
    );
    settings.maxDisplacement = dictionaryInput::getPositiveOrDefault
    (
        dict, "maxDisplacement", dimless, settings.maxDisplacement
    );
    settings.blocks = dictionaryInput::getLabelOrDefault
    (
        dict, "blocks", settings.blocks, 1, 1024
    );
    if (settings.blocks & (settings.blocks - 1))
    {
        dictionaryInput::badValue
        (
            dict, "blocks", Foam::name(settings.blocks), "a power of two"
        );
    }
    return settings;
}


nscd::Grains<2> Foam::grainProperties::grains(const dictionary& source) const
{
    nscd::Grains<2> result;
    try
    {
        result = grainSource::New
        (
            source, {plane_, materials_, walls_, contact_, g_}
        )->read();
    }
    catch (const std::exception& err)
    {
        FatalIOErrorInFunction(source)
            << "Keyword '" << source.dictName() << "': " << err.what()
            << exit(FatalIOError);
    }

    for (double& mass : result.mass)
    {
        mass *= packingRatio_;
    }
    return result;
}


nscd::Grains<2> Foam::grainProperties::initialGrains() const
{
    return grains(dictionaryInput::subDict(dict_, "initialGrains"));
}
