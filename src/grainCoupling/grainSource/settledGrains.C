/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "settledGrains.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "grainMaterials.H"
#include "nscd/Packing.hpp"
#include "planarMesh.H"

namespace Foam
{
namespace grainSources
{
    defineTypeNameAndDebug(settled, 0);
    addToRunTimeSelectionTable(grainSource, settled, dictionary);
}
}


Foam::grainSources::settled::settled
(
    const dictionary& dict,
    const context& ctx
)
:
    grainSource(ctx),
    dict_(dict),
    deltaT_(dictionaryInput::getPositive(dict, "deltaT", dimTime)),
    maxSpeed_
    (
        dictionaryInput::getPositiveOrDefault
        (
            dict, "maxSpeed", dimVelocity, 1e-3
        )
    ),
    maxTime_
    (
        dictionaryInput::getPositiveOrDefault(dict, "maxTime", dimTime, 100)
    )
{
    dictionaryInput::checkKeywords
    (
        dict, {"type", "from", "deltaT", "maxSpeed", "maxTime", "output"}
    );
}


nscd::Grains<2> Foam::grainSources::settled::read() const
{
    // Grains at rest need few sweeps, but on the way there a pile that is not
    // solved to the tolerance creeps
    nscd::Settings contact(context_.contact);
    contact.maxSweeps = std::max(contact.maxSweeps, 1000);

    const nscd::Settled<2> result = nscd::settle<2>
    (
        nscd::ContactDynamics<2>
        (
            grainSource::New
            (
                dictionaryInput::subDict(dict_, "from"), context_
            )->read(),
            context_.walls,
            context_.materials.contactTable(),
            contact
        ),
        context_.plane.toPlane(context_.g),
        deltaT_,
        maxSpeed_,
        maxTime_
    );

    if (result.maxVelocity > maxSpeed_)
    {
        dictionaryInput::badValue
        (
            dict_, "maxTime", Foam::name(maxTime_),
            "a time in which the grains come to rest; the fastest still moves"
            " at " + Foam::name(result.maxVelocity) + " m/s"
        );
    }
    Info<< "Grains settled in " << result.time << " s" << endl;

    nscd::Grains<2> grains(result.grains);
    std::fill
    (
        grains.velocity.begin(), grains.velocity.end(),
        nscd::Vector<2>::Zero()
    );
    std::fill
    (
        grains.spin.begin(), grains.spin.end(), nscd::Spin<2>::Zero()
    );
    return grains;
}
