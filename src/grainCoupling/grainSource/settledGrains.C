/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "settledGrains.H"

#include "dictionaryInput.H"
#include "grainMaterials.H"
#include "grainWalls.H"
#include "nscd/Packing.hpp"

addToSelection(grainSource, grainSources, settled)

template<int D>
Foam::grainSources::settled<D>::settled
(
    const dictionary& dict,
    const typename grainSource<D>::context& ctx
)
:
    grainSource<D>(dict, ctx),
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


template<int D>
nscd::Grains<D> Foam::grainSources::settled<D>::read() const
{
    // Grains at rest need few sweeps, but on the way there a pile that is not
    // solved to the tolerance creeps
    nscd::Settings contact(this->context_.contact);
    contact.maxSweeps = std::max(contact.maxSweeps, 1000);

    const nscd::Settled<D> result = nscd::settle<D>
    (
        nscd::ContactDynamics<D>
        (
            grainSource<D>::New
            (
                dictionaryInput::subDict(dict_, "from"), this->context_
            )->read(),
            this->context_.walls.walls(),
            this->context_.materials.contactTable(),
            contact,
            MPI_COMM_WORLD,
            this->context_.walls.bodies()
        ),
        this->context_.space.fromSpace(this->context_.g),
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

    nscd::Grains<D> grains(result.grains);
    std::fill
    (
        grains.velocity.begin(), grains.velocity.end(),
        nscd::Vector<D>::Zero()
    );
    std::fill
    (
        grains.spin.begin(), grains.spin.end(), nscd::Spin<D>::Zero()
    );
    return grains;
}
