/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "packingReport.H"

#include "grainChecks.H"
#include "nscd/walls/WallMotion.hpp"
#include "volFields.H"

#include <cmath>
#include <numeric>

template<int D>
void Foam::printPacking
(
    const grainProperties<D>& properties,
    const nscd::Grains<D>& grains
)
{
    Info<< nl << "Number of grains        " << label(grains.size()) << nl;
    if (!grains.size())
    {
        return;
    }

    const std::vector<double>& r = grains.radius;
    const auto range = std::minmax_element(r.begin(), r.end());
    const scalar smallest = 2**range.first;
    const scalar largest = 2**range.second;

    const grainSpace<D>& space = properties.space();

    scalar volume = 0;
    Eigen::AlignedBox<double, D> box;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const nscd::Vector<D> reach(nscd::Vector<D>::Constant(r[i]));
        volume += space.volume(grains, i);
        box.extend(grains.position[i] - reach);
        box.extend(grains.position[i] + reach);
    }

    const Pair<scalar> h(space.cellSizeRange());

    Info<< "Diameter                smallest " << smallest << ", mean "
        << 2*std::accumulate(r.begin(), r.end(), 0.0)/r.size()
        << ", largest " << largest << " m" << nl
        << "Mass                    "
        << std::accumulate(grains.mass.begin(), grains.mass.end(), 0.0)
        << " kg" << space.ofDepth().c_str() << nl
        << "Bounding box            " << space.toSpace(box.min()) << ' '
        << space.toSpace(box.max()) << nl
        << "Packing fraction        "
        << volume/(box.sizes().prod()*space.depth())
        << " of the bounding box, "
        << volume/gSum(space.mesh().V().field()) << " of the mesh" << nl;
    if (properties.dict().found("coupling"))
    {
        Info<< "Seen by the fluid       " << properties.packingRatio()
            << " of that" << nl;
    }
    Info<< "Cell size h             " << h.first() << " to " << h.second()
        << " m, h/d from " << h.first()/largest << " to "
        << h.second()/smallest << endl;
}


namespace Foam
{

//- Of all grains and free walls, of which any two may meet
template<int D>
scalar massRatio(const grainProperties<D>& properties, const nscd::Grains<D>& grains)
{
    scalar smallest = GREAT, largest = 0;
    for (const scalar m : grains.mass)
    {
        smallest = min(smallest, m);
        largest = max(largest, m);
    }
    for (const auto& body : properties.walls().bodies())
    {
        if (std::isfinite(body.mass))
        {
            smallest = min(smallest, body.mass);
            largest = max(largest, body.mass);
        }
    }
    return largest > 0 ? largest/smallest : 1;
}


//- Warn of a solver that cannot cope with them (doc/theory/contacts.md,
//  "Solvers")
template<int D>
void checkMassRatio(const grainProperties<D>& properties, const nscd::Grains<D>& grains)
{
    const bool accelerated = properties.contact().solver == nscd::Solver::sweeps;
    const scalar limit = accelerated ? 1e6 : 1e3;
    const scalar ratio = massRatio(properties, grains);
    if (ratio > limit)
    {
        Info<< "Warning: masses of grains and free walls differ by a factor of "
            << ratio << "; where heavy ones rest on light ones the solver"
            << " converges up to " << limit
            << (accelerated ? "" : ", 'sweeps' up to 1e6") << endl;
    }
}

void addCorners(const nscd::Segment& wall, nscd::Vectors<2>& corners)
{
    corners.insert(corners.end(), {wall.a, wall.b});
}


void addCorners
(
    const std::variant<nscd::Plane, nscd::Triangle>& wall,
    nscd::Vectors<3>& corners
)
{
    if (const nscd::Triangle* t = std::get_if<nscd::Triangle>(&wall))
    {
        corners.insert(corners.end(), {t->a, t->b, t->c});
    }
}


//- Of each entry of 'walls'; inverted for a plane, which has no end
template<int D>
std::vector<boundBox> boundsOfEntries
(
    const grainProperties<D>& properties,
    const std::vector<nscd::WallBody<D>>& bodies
)
{
    const grainWalls<D>& walls = properties.walls();
    std::vector<boundBox> bounds;
    for (const wallExtent& wall : walls.extents())
    {
        bounds.push_back(wall.body < 0 ? wall.bounds : boundBox());
    }
    const auto moved = nscd::rigidMotions(walls.bodies(), bodies);
    for (std::size_t i = 0; i < walls.walls().size(); ++i)
    {
        const int body = nscd::bodyOf(walls.walls()[i]);
        nscd::Vectors<D> corners;
        if (body >= 0)
        {
            addCorners(walls.walls()[i], corners);
        }
        for (const nscd::Vector<D>& corner : corners)
        {
            bounds[walls.entry()[label(i)]].add
            (
                properties.space().positionInSpace(moved[body](corner))
            );
        }
    }
    return bounds;
}

} // End namespace Foam


template<int D>
void Foam::printWalls
(
    const grainProperties<D>& properties,
    const std::vector<nscd::WallBody<D>>& bodies
)
{
    const std::vector<boundBox> bounds(boundsOfEntries(properties, bodies));
    for (std::size_t i = 0; i < bounds.size(); ++i)
    {
        const wallExtent& wall = properties.walls().extents()[i];
        Info<< "Wall " << wall.name << ": ";
        if (bounds[i].valid())
        {
            Info<< wall.nPieces << (D == 2 ? " segments" : " faces") << " from "
                << bounds[i].min() << " to " << bounds[i].max() << nl;
        }
        else
        {
            Info<< "a plane" << nl;
        }
    }
}


template<int D>
bool Foam::printFaults
(
    const grainProperties<D>& properties,
    const nscd::Grains<D>& grains,
    const std::vector<nscd::WallBody<D>>& bodies,
    const bool areOfState
)
{
    const grainChecks<D> checks(properties, grains);
    const labelList outside(checks.outside());
    const auto overlaps(checks.overlaps(1e-9, bodies));
    const auto refused(checks.overlaps(properties.allowedOverlap(), bodies));

    scalar worst = 0;
    for (const auto& o : overlaps)
    {
        worst = max(worst, o.depth);
    }

    Info<< "Outside the mesh        " << outside.size() << " grains";
    if (outside.size())
    {
        Info<< ", the first at "
            << properties.space().positionInSpace(grains.position[outside[0]]);
    }
    Info<< nl << "Overlaps                " << label(overlaps.size())
        << ", worst " << worst << " m; above 'allowedOverlap' "
        << properties.allowedOverlap() << " of a diameter: "
        << label(refused.size()) << endl;
    checkMassRatio(properties, grains);

    return (areOfState || outside.empty()) && refused.empty();
}


template void Foam::printPacking
(
    const grainProperties<2>&, const nscd::Grains<2>&
);
template void Foam::printPacking
(
    const grainProperties<3>&, const nscd::Grains<3>&
);
template bool Foam::printFaults
(
    const grainProperties<2>&,
    const nscd::Grains<2>&,
    const std::vector<nscd::WallBody<2>>&,
    const bool
);
template bool Foam::printFaults
(
    const grainProperties<3>&,
    const nscd::Grains<3>&,
    const std::vector<nscd::WallBody<3>>&,
    const bool
);
template void Foam::printWalls
(
    const grainProperties<2>&, const std::vector<nscd::WallBody<2>>&
);
template void Foam::printWalls
(
    const grainProperties<3>&, const std::vector<nscd::WallBody<3>>&
);
