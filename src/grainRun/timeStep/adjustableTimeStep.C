/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "adjustableTimeStep.H"

#include "dictionaryInput.H"
#include "fvcSurfaceIntegrate.H"
#include "refuseFunctions.H"
#include "requireTimeStep.H"
#include "writeForALook.H"

Foam::adjustableTimeStep::limits::limits(const dictionary& dict)
:
    adjusts(dict.getOrDefault("adjustTimeStep", false)),
    maxCo(dictionaryInput::getPositiveOrDefault(dict, "maxCo", dimless, 1)),
    maxGrainCo
    (
        dictionaryInput::getPositiveOrDefault(dict, "maxGrainCo", dimless, 0.5)
    ),
    maxGrainDisplacement
    (
        dictionaryInput::getPositiveOrDefault
        (
            dict, "maxGrainDisplacement", dimless, 0.1
        )
    ),
    maxDeltaT
    (
        dictionaryInput::getPositiveOrDefault(dict, "maxDeltaT", dimTime, GREAT)
    ),
    minDeltaT
    (
        dictionaryInput::getPositiveOrDefault
        (
            dict, "minDeltaT", dimTime,
            min(1e-6*dict.getOrDefault<scalar>("deltaT", 0), maxDeltaT)
        )
    )
{
    if (minDeltaT > maxDeltaT)
    {
        dictionaryInput::badValue
        (
            dict, "minDeltaT", name(minDeltaT),
            "a value up to maxDeltaT = " + name(maxDeltaT)
        );
    }
}


Foam::adjustableTimeStep::adjustableTimeStep
(
    Time& runTime,
    const grainSystem& grains,
    const carrier& fluid
)
:
    time_(runTime),
    times_(runTime),
    grains_(grains),
    weight_(grains, fluid)
{
    requireTimeStep(runTime);
    refuseFunctions(runTime);
    limits checked(runTime.controlDict());
}


Foam::scalar Foam::adjustableTimeStep::grown
(
    const scalar before,
    const scalar limit
)
{
    return min(limit, before*min(1 + 0.1*limit/before, scalar(1.2)));
}


Foam::scalar Foam::adjustableTimeStep::timeToMove
(
    const scalar distance,
    const scalar v,
    const scalar a
)
{
    const scalar root = v + std::sqrt(v*v + 4*a*distance);
    return root > 0 ? 2*distance/root : GREAT;
}


Foam::scalar Foam::adjustableTimeStep::courantOfFluid
(
    const surfaceScalarField& phiU
) const
{
    const scalarField sumPhi(fvc::surfaceSum(mag(phiU))().primitiveField());
    return 0.5*gMax(sumPhi/grains_.mesh().V().field());
}


Foam::scalar Foam::adjustableTimeStep::courantOfGrains() const
{
    const fvMesh& mesh = grains_.mesh();
    const overlapList& overlaps = grains_.overlaps();
    const vectorField& Sf = mesh.faceAreas();

    scalar worst = 0;
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        const vector v(grains_.motion().velocity(graini));
        for (const cellOverlap& o : overlaps.of(graini))
        {
            scalar sum = 0;
            for (const label facei : mesh.cells()[o.cell])
            {
                sum += mag(v & Sf[facei]);
            }
            worst = max(worst, 0.5*sum/mesh.V()[o.cell]);
        }
    }
    return returnReduce(worst, maxOp<scalar>());
}


Foam::scalar Foam::adjustableTimeStep::mostOfGrains() const
{
    const grainMotion& motion = grains_.motion();
    scalar fastest = 0;
    for (label graini = 0; graini < motion.size(); ++graini)
    {
        fastest = max(fastest, magSqr(motion.velocity(graini)));
    }
    const fvMesh& mesh = grains_.mesh();
    const scalarField faces(fvc::surfaceSum(mesh.magSf())().primitiveField());
    return 0.5*std::sqrt(fastest)*gMax(faces/mesh.V().field());
}


Foam::scalar Foam::adjustableTimeStep::displacementLimit
(
    const scalar fraction
) const
{
    const grainMotion& motion = grains_.motion();
    const Pair<scalar> rho(weight_.rhoRange());
    return displacementLimit
    (
        motion, fraction,
        [&](const label i)
        {
            const buoyancy::ofGrain weight(weight_.of(i));
            return max
            (
                mag(weight.acceleration(rho.first())),
                mag(weight.acceleration(rho.second()))
            );
        }
    );
}


Foam::scalar Foam::adjustableTimeStep::displacementLimit
(
    const grainView& grains,
    const scalar fraction,
    const std::function<scalar(label)>& acceleration
)
{
    scalar smallest = GREAT;
    for (label i = 0; i < grains.size(); ++i)
    {
        smallest = min(smallest, grains.radius(i));
    }
    scalar limit = GREAT;
    for (label i = 0; i < grains.size(); ++i)
    {
        limit = min
        (
            limit,
            timeToMove
            (
                fraction*2*smallest, mag(grains.velocity(i)), acceleration(i)
            )
        );
    }
    return limit;
}


void Foam::adjustableTimeStep::warnOnce(const surfaceScalarField& phiU)
{
    if (hasWarned_)
    {
        return;
    }
    const scalar ofFluid = courantOfFluid(phiU)*time_.deltaTValue();
    if (max(ofFluid, mostOfGrains()*time_.deltaTValue()) <= 1)
    {
        return;
    }
    const scalar ofGrains = courantOfGrains()*time_.deltaTValue();
    if (max(ofFluid, ofGrains) > 1)
    {
        hasWarned_ = true;
        WarningInFunction
            << "Courant number " << ofFluid << " of the fluid, " << ofGrains
            << " of the grains after time " << time_.timeName() << nl
            << "    above 1 a step is longer than the fluid or a grain stays in"
            << " a cell: the exchange between them is out of date within it;"
            << nl << "    a smaller deltaT, or 'adjustTimeStep yes', avoids it"
            << " (said once)" << endl;
    }
}


void Foam::adjustableTimeStep::set
(
    const surfaceScalarField& phiU,
    const std::vector<namedLimit>& more
)
{
    const limits given(time_.controlDict());
    if (!given.adjusts)
    {
        warnOnce(phiU);
        return;
    }

    std::vector<namedLimit> all
    ({
        {"maxCo", given.maxCo/max(courantOfFluid(phiU), VSMALL)},
        {"maxGrainCo", given.maxGrainCo/max(courantOfGrains(), VSMALL)},
        {
            "maxGrainDisplacement",
            displacementLimit(given.maxGrainDisplacement)
        },
        {"frequency", grains_.motion().maxDeltaTOfWalls()},
        {"maxDeltaT", given.maxDeltaT}
    });
    all.insert(all.end(), more.begin(), more.end());
    take(time_, times_, grains_.motion().lastTimeStep(), all, given.minDeltaT);
}


void Foam::adjustableTimeStep::take
(
    Time& runTime,
    const writingTimes& times,
    const scalar last,
    const std::vector<namedLimit>& all,
    const scalar least
)
{
    // Grains that are fixed, and none, have no last step
    const scalar before = last > 0 ? last : runTime.deltaTValue();
    const bool isFirst = !(last > 0) && runTime.timeIndex() == 0;

    Info<< nl << "Limits of deltaT:";
    const char* governing = "";
    scalar limit = GREAT;
    for (const auto& one : all)
    {
        if (one.second < GREAT)
        {
            Info<< ' ' << one.first << ' ' << one.second << " s,";
        }
        if (one.second < limit)
        {
            governing = one.first;
            limit = one.second;
        }
    }

    if (limit < least)
    {
        Info<< endl;
        const bool isWritten =
            writeForALook(runTime, "The time step has become too short");
        FatalErrorInFunction
            << "The time step after time " << runTime.timeName() << " would be "
            << limit << " s by " << governing << ", less than minDeltaT "
            << least << " s" << nl
            << "    something has gone wrong before"
            << (isWritten ? "; the fields are written for a look" : "")
            << "; a run continues from the last complete time, with a smaller"
            << " minDeltaT in system/controlDict (a millionth of deltaT, if not"
            << " given) beyond this one"
            << exit(FatalError);
    }

    scalar deltaT = isFirst ? min(before, limit) : grown(before, limit);
    if (deltaT < limit)
    {
        governing = isFirst ? "deltaT" : "growth";
    }

    const scalar toWrite = times.toNext(deltaT);
    deltaT = times.step(deltaT);
    runTime.setDeltaT(deltaT, false);
    Info<< " deltaT = " << deltaT << " s by " << governing;
    if (toWrite < GREAT)
    {
        Info<< ", " << label(std::round(toWrite/deltaT))
            << " steps to the next time of writing";
    }
    Info<< endl;
}
