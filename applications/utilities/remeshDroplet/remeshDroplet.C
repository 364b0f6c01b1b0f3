/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later

Application
    remeshDroplet

Group
    grpGrainPreProcessing

Description
    A new mesh of triangles that fits the droplet of the last time of a plane case
    of grainDropletFoam, and all its fields there (doc/theory, eq. 10.22, 10.23).

    Boundary faces stay as they are, and zones of cells where they were.  The mesh is
    written to the time, that of the start to constant; fields are written in the
    place of what they were.  Fluxes and values of steps before are removed, as the
    solver makes them anew, and zones of faces and points, and sets.

Usage
    system/remeshDropletDict:
    \verbatim
    cells       12;
    growth      0.1;
    largest     5e-4;
    \endverbatim

    \table
        Property | Description                                | Required | Default
        cells    | in the droplet's diameter, 4 to 1000       | yes      |
        growth   | of cells for each metre from its surface [-], 0.01 to 1 | no | 0.1
        largest  | cell [m], > 0                              | yes      |
    \endtable

\*---------------------------------------------------------------------------*/

#include "fvCFD.H"

#include "conservativeMap.H"
#include "dictionaryInput.H"
#include "fittedMesh.H"
#include "incompleteTimes.H"
#include "liquidDroplets.H"
#include "overlap/disc/DiscPolygon.hpp"
#include "timeFields.H"

#include <memory>

namespace
{

// Share of fluid in the cells, as grainDropletFoam has it
scalarField shares(const grainSystem& grains, const liquidDroplets& droplets)
{
    const fvMesh& mesh = grains.mesh();
    scalarField solid(mesh.nCells(), Zero);
    for (const cellOverlap& o : grains.overlaps().all())
    {
        solid[o.cell] += o.volume/mesh.V()[o.cell];
    }
    grains.voidFraction().smooth(solid);
    forAll(solid, celli)
    {
        solid[celli] =
            max(1 - solid[celli], scalar(0))*(1 - droplets.filled(celli));
    }
    return solid;
}


// What a case has in its cells and of its grains at a time
struct caseState
{
    const planarMesh plane;

    const grainSystem grains;

    const liquidDroplets droplets;

    const scalarField share;

    explicit caseState(const fvMesh& mesh)
    :
        plane(mesh),
        grains(mesh, Zero, true),
        droplets(mesh, Zero, 1),
        share(shares(grains, droplets))
    {}
};


triangulation::sizes readSizes(const fvMesh& mesh, const scalar radius)
{
    const IOdictionary dict
    (
        IOobject
        (
            "remeshDropletDict", mesh.time().system(), mesh,
            IOobject::MUST_READ, IOobject::NO_WRITE, false
        )
    );
    dictionaryInput::checkKeywords
    (
        dict, {"FoamFile", "cells", "growth", "largest"}
    );
    triangulation::sizes result;
    result.least =
        2*radius/dictionaryInput::getScalar(dict, "cells", dimless, 4, 1000);
    result.growth = dictionaryInput::getScalarOrDefault
    (
        dict, "growth", dimless, 0.1, 0.01, 1
    );
    result.most = max
    (
        result.least, dictionaryInput::getPositive(dict, "largest", dimLength)
    );
    return result;
}


// Name and place of the one droplet
triangulation::circle circleOf(const caseState& state)
{
    const label n = state.droplets.size();
    if (n != 1)
    {
        FatalErrorInFunction
            << "There are " << n << " droplets at time "
            << state.plane.mesh().time().timeName() << nl
            << "    allowed: one" << exit(FatalError);
    }
    const grainSystem& system = state.droplets.system();
    return
    {
        state.plane.toPlane(system.centres()[0]), 0.5*system.fluidDiameter(0)
    };
}


// Fatal if the boundary is so near that cells between would be slivers
void requireRoom
(
    const planarMesh& plane,
    const planarOutline& outline,
    const triangulation::circle& droplet,
    const triangulation::sizes& size
)
{
    constexpr scalar thinnest = 0.1;
    const scalar room = outline.distance(droplet.centre) - droplet.radius;
    if (room < thinnest*size.least)
    {
        FatalErrorInFunction
            << "The droplet at " << plane.positionInSpace(droplet.centre)
            << " of diameter " << 2*droplet.radius << " m is "
            << max(room, scalar(0)) << " m from the boundary of the mesh" << nl
            << "    allowed: " << thinnest*size.least << " m at least, "
            << thinnest << " of a cell at its surface" << exit(FatalError);
    }
}


// Outside of the droplet and of grains
conservativeMap::openArea openAreas
(
    const caseState& state,
    const triangulation::circle& droplet
)
{
    auto grains = std::make_shared<labelListList>(state.plane.nCells());
    for (label i = 0; i < state.grains.size(); ++i)
    {
        for (const cellOverlap& o : state.grains.overlaps().of(i))
        {
            (*grains)[o.cell].append(i);
        }
    }
    return [&state, droplet, grains]
    (
        const label celli,
        const std::vector<planarMesh::point2>& part
    )
    {
        const auto inDisc = [&](const planarMesh::point2& x, const scalar r)
        {
            return overlap::discPolygon(x, r, part.data(), part.size()).area;
        };
        const scalar area = overlap::polygon(part.data(), part.size()).area;
        scalar solid = 0;
        for (const label i : (*grains)[celli])
        {
            for (const grainMember& m : state.grains.members(i))
            {
                solid += inDisc(state.plane.toPlane(m.centre), m.radius);
            }
        }
        return
            max(1 - solid/area, scalar(0))
           *max(area - inDisc(droplet.centre, droplet.radius), scalar(0));
    };
}

}


int main(int argc, char *argv[])
{
    argList::noParallel();
    argList::addNote("A new mesh that fits the droplet, and all fields on it.");
    #include "setRootCase.H"

    setAsideIncompleteTimes(args);

    // The last time, and it again for what is new
    Time runTime(Time::controlDictName, args);
    const instant last(runTime.times().last());
    runTime.setTime(last, runTime.times().size() - 1);
    Time freshTime(Time::controlDictName, args);
    freshTime.setTime(last, runTime.timeIndex());
    Info<< "Time = " << runTime.timeName() << nl << endl;

    const fvMesh mesh
    (
        IOobject
        (
            fvMesh::defaultRegion, runTime.timeName(), runTime,
            IOobject::MUST_READ
        )
    );
    const caseState old(mesh);
    const triangulation::circle hole(circleOf(old));
    const planarOutline outline(old.plane);
    const triangulation::sizes sizes(readSizes(mesh, hole.radius));
    requireRoom(old.plane, outline, hole, sizes);
    const triangulation triangles(outline, hole, sizes);
    const bool isStart =
        runTime.value() <= 0 && mesh.facesInstance() == runTime.constant();
    const autoPtr<fvMesh> freshMesh
    (
        fittedMesh
        (
            old.plane, outline, triangles, freshTime,
            isStart ? runTime.constant() : runTime.timeName()
        )
    );
    timeFields fields(mesh, freshMesh());
    const caseState fresh(freshMesh());
    const conservativeMap map
    (
        old.plane, old.share, fresh.plane, fresh.share, openAreas(old, hole)
    );
    Info<< mesh.nCells() << " cells become " << freshMesh().nCells()
        << "; share of the fluid that finds no place: " << map.defect()
        << ", gain of its volume " << map.gain() << nl;

    fields.map(map, old.share, fresh.share);

    // From here on nothing fails for what the case has
    fields.write();
    rm(mesh.time().timePath()/"uniform"/"dropletMotion");
    freshMesh().removeFiles(freshMesh().facesInstance());
    freshMesh().write();

    Info<< nl << "End" << endl;
    return 0;
}
