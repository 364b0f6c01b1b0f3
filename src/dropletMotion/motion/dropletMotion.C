/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dropletMotion.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "emptyPolyPatch.H"
#include "fvMesh.H"
#include "grainView.H"
#include "patchDistance.H"
#include "polyMeshTools.H"
#include "processorPolyPatch.H"
#include "unitConversion.H"

namespace
{

// Of the droplet's way, over the way from its surface to the end of the reach: all of
// it in the first part, as cells at the surface of a heavy body must stay as they are
Foam::scalar shareOf(const Foam::scalar x)
{
    constexpr Foam::scalar rigid = 0.25;
    return Foam::max(Foam::min((1 - x)/(1 - rigid), 1.0), 0.0);
}

}

namespace Foam
{
    defineTypeNameAndDebug(dropletMotion, 0);
    addToRunTimeSelectionTable(motionSolver, dropletMotion, dictionary);
}


Foam::dropletMotion::dropletMotion
(
    const polyMesh& mesh,
    const IOdictionary& dict
)
:
    motionSolver(mesh, dict, typeName),
    reach_(dictionaryInput::getPositive(coeffDict(), "reach", dimLength)),
    maxNonOrtho_
    (
        dictionaryInput::getScalarOrDefault
        (
            coeffDict(), "maxNonOrtho", dimless, 60, 0, 90
        )
    ),
    maxSkewness_
    (
        dictionaryInput::getPositiveOrDefault
        (
            coeffDict(), "maxInternalSkewness", dimless, 2
        )
    ),
    fitted_
    (
        IOobject
        (
            typeName,
            mesh.time().timeName(),
            "uniform",
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    points_(mesh.points()),
    stops_(false)
{
    dictionaryInput::checkKeywords
    (
        coeffDict(), {"reach", "maxNonOrtho", "maxInternalSkewness"}
    );
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (patch.coupled() && !isA<processorPolyPatch>(patch))
        {
            dictionaryInput::badValue
            (
                dict, "solver", typeName,
                "other motion solvers, as the mesh has the coupled patch '"
              + patch.name() + "', at which it would break"
            );
        }
    }
}


Foam::scalar Foam::dropletMotion::patchDistanceOf(const point& x) const
{
    DynamicList<label> patches;
    for (const polyPatch& patch : mesh().boundaryMesh())
    {
        if (!isA<emptyPolyPatch>(patch) && !patch.coupled())
        {
            patches.append(patch.index());
        }
    }
    return patchDistance(mesh(), patches).fromPatches(List<point>(1, x))[0];
}


void Foam::dropletMotion::checkQuality()
{
    const scalar orthogonality = returnReduce
    (
        min
        (
            polyMeshTools::faceOrthogonality
            (
                mesh(), mesh().faceAreas(), mesh().cellCentres()
            )()
        ),
        minOp<scalar>()
    );
    const scalar skewness = returnReduce
    (
        max
        (
            polyMeshTools::faceSkewness
            (
                mesh(), mesh().points(), mesh().faceCentres(),
                mesh().faceAreas(), mesh().cellCentres()
            )()
        ),
        maxOp<scalar>()
    );
    const scalar nonOrtho = radToDeg(::acos(min(orthogonality, scalar(1))));
    Info<< "Mesh that follows the droplet: non-orthogonality " << nonOrtho
        << " degrees, skewness " << skewness << endl;
    if (!stops_ && (nonOrtho > maxNonOrtho_ || skewness > maxSkewness_))
    {
        Info<< "    worse than the limits of constant/dynamicMeshDict, "
            << maxNonOrtho_ << " and " << maxSkewness_
            << ": the run stops after the next step, to go on after remeshDroplet"
            << endl;
        stop();
    }
}


void Foam::dropletMotion::checkRoom(const scalar reach, const scalar way)
{
    // Before it is too late: cells that a step compresses by more than an eighth do
    // not keep temperatures within what there was
    constexpr scalar steps = 10;
    if (!stops_ && reach < steps*way)
    {
        Info<< "    The droplet is " << reach << " m from a patch, less than " << steps
            << " steps like this one: the run stops after the next step, to go on"
            << " with shorter steps, or with a mesh that does not follow it" << endl;
        stop();
    }
}


void Foam::dropletMotion::stop()
{
    stops_ = true;
    const_cast<Time&>(mesh().time()).stopAt(Time::saWriteNow);
}


void Foam::dropletMotion::solve()
{
    points_ = mesh().points();
    if (!mesh().foundObject<grainView>("droplets"))
    {
        dictionaryInput::badValue
        (
            *this, "solver", typeName,
            "other motion solvers, as this program has no droplets"
        );
    }
    const grainView& droplets = mesh().lookupObject<grainView>("droplets");
    if (droplets.size() > 1)
    {
        FatalIOErrorInFunction(*this)
            << "Keyword 'solver' is " << typeName << ", and there are "
            << droplets.size() << " droplets" << nl
            << "    allowed: one droplet, or a mesh that does not follow them"
            << exit(FatalIOError);
    }
    if (droplets.size() == 0)
    {
        return;
    }
    checkQuality();

    const point centre(droplets.centre(0));
    const scalar radius = droplets.radius(0);
    const point oldCentre(fitted_.lookupOrDefault<point>("centre", centre));
    const scalar oldRadius = fitted_.lookupOrDefault<scalar>("radius", radius);
    fitted_.set("centre", centre);
    fitted_.set("radius", radius);

    const scalar reach = min(reach_, patchDistanceOf(oldCentre) - oldRadius);
    const vector way(centre - oldCentre);
    const scalar growth = radius - oldRadius;
    checkRoom(reach, mag(way) + mag(growth));
    if (reach < 2*(mag(way) + mag(growth)))
    {
        FatalErrorInFunction
            << "The droplet at " << centre << " is " << max(reach, scalar(0))
            << " m from a patch, too near for a mesh that follows it" << nl
            << "    allowed: droplets away from walls, or a mesh that does not"
            << " follow them; a run continues from the last complete time"
            << exit(FatalError);
    }
    const Vector<label>& directions = mesh().geometricD();
    for (point& x : points_)
    {
        vector arm(x - oldCentre);
        for (direction i = 0; i < vector::nComponents; ++i)
        {
            arm[i] = directions[i] < 0 ? 0 : arm[i];
        }
        const scalar r = max(mag(arm), VSMALL);
        const scalar share = shareOf((r - oldRadius)/reach);
        x += share*(way + growth/max(r, oldRadius)*arm);
    }
}


Foam::tmp<Foam::pointField> Foam::dropletMotion::curPoints() const
{
    return tmp<pointField>(new pointField(points_));
}
