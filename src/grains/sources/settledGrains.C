/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "settledGrains.H"

#include "clockTime.H"
#include "dictionaryInput.H"
#include "grainMaterials.H"
#include "grainWalls.H"
#include "nscd/packing/Packing.hpp"

addToSelection(grainSource, grainSources, settled)

namespace
{

// Of real time [s]
constexpr Foam::scalar betweenReports = 1;

}


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
Foam::scalar Foam::grainSources::settled<D>::lowestInMesh() const
{
    const vector down(normalised(this->context_.g));
    scalar lowest = -GREAT;
    for (const point& x : this->context_.space.mesh().points())
    {
        lowest = max(lowest, down & x);
    }
    reduce(lowest, maxOp<scalar>());
    return lowest;
}


template<int D>
void Foam::grainSources::settled<D>::requireAboveFloor
(
    const nscd::Grains<D>& grains,
    const scalar lowest
) const
{
    const vector down(normalised(this->context_.g));
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const point x(this->context_.space.positionInSpace(grains.position[i]));
        if ((down & x) > lowest + grains.radius[i])
        {
            FatalIOErrorInFunction(dict_)
                << "Keyword 'from': grain " << label(grains.id[i])
                << " has left the walls and fallen out of the mesh, to " << x << nl
                << "    allowed: grains that do not overlap, between walls below"
                << " which none can get" << exit(FatalIOError);
        }
    }
}


template<int D>
nscd::Grains<D> Foam::grainSources::settled<D>::atRest
(
    const nscd::Grains<D>& grains
) const
{
    // Grains at rest need few sweeps, but on the way there a pile that is not
    // solved to the tolerance creeps
    nscd::Settings contact(this->context_.contact);
    contact.maxSweeps = std::max(contact.maxSweeps, 1000);

    const scalar lowest = lowestInMesh();
    const clockTime clock;
    scalar lastReport = 0;
    Info<< "Settling " << label(grains.size()) << " grains, at most "
        << maxTime_ << " s" << endl;

    nscd::Settled<D> result = nscd::settle<D>
    (
        nscd::ContactDynamics<D>
        (
            grains,
            this->context_.walls.walls(),
            this->context_.materials.contactTable(),
            contact,
            MPI_COMM_WORLD,
            this->context_.walls.bodies()
        ),
        this->context_.space.fromSpace(this->context_.g),
        deltaT_,
        maxSpeed_,
        maxTime_,
        [&](const scalar time, const scalar fastest, const nscd::Grains<D>& now)
        {
            requireAboveFloor(now, lowest);
            const scalar worked = clock.elapsedTime();
            if (worked > lastReport + betweenReports)
            {
                lastReport = worked;
                Info<< "    " << time << " s: the fastest moves at " << fastest
                    << " m/s, after " << worked << " s of work"
                    << endl;
            }
        }
    );

    if (!result.atRest)
    {
        dictionaryInput::badValue
        (
            dict_, "maxTime", Foam::name(maxTime_),
            "a time in which the grains come to rest and stay so; the fastest"
            " moves at " + Foam::name(result.maxVelocity) + " m/s"
        );
    }
    Info<< "Grains settled in " << result.time << " s" << endl;

    std::fill
    (
        result.grains.velocity.begin(), result.grains.velocity.end(),
        nscd::Vector<D>::Zero()
    );
    std::fill
    (
        result.grains.spin.begin(), result.grains.spin.end(),
        nscd::Spin<D>::Zero()
    );
    return result.grains;
}


template<int D>
nscd::Grains<D> Foam::grainSources::settled<D>::read() const
{
    const nscd::Grains<D> start
    (
        grainSource<D>::New
        (
            dictionaryInput::subDict(dict_, "from"), this->context_
        )->read()
    );

    // Wedged grains hang on forces that only their history explains.  A run
    // starts without them, and so does the second settling.
    return atRest(atRest(start));
}
