/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "packingReport.H"

#include "grainChecks.H"
#include "mathematicalConstants.H"
#include "volFields.H"

#include <numeric>

void Foam::printPacking
(
    const grainProperties& properties,
    const nscd::Grains<2>& grains
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

    scalar area = 0;
    Eigen::AlignedBox2d box;
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const Eigen::Vector2d reach(r[i], r[i]);
        area += constant::mathematical::pi*sqr(r[i]);
        box.extend(grains.position[i] - reach);
        box.extend(grains.position[i] + reach);
    }

    const planarMesh& plane = properties.plane();
    const Pair<scalar> h(plane.cellSizeRange());

    Info<< "Diameter                smallest " << smallest << ", mean "
        << 2*std::accumulate(r.begin(), r.end(), 0.0)/r.size()
        << ", largest " << largest << " m" << nl
        << "Mass                    "
        << std::accumulate(grains.mass.begin(), grains.mass.end(), 0.0)
        << " kg in a mesh of depth " << plane.depth() << " m" << nl
        << "Bounding box            " << plane.toSpace(box.min()) << ' '
        << plane.toSpace(box.max()) << nl
        << "Packing fraction        " << area/box.sizes().prod()
        << " of the bounding box, "
        << area/gSum(plane.mesh().V().field())*plane.depth()
        << " of the mesh" << nl
        << "Seen by the fluid       " << properties.packingRatio()
        << " of that" << nl
        << "Cell size h             " << h.first() << " to " << h.second()
        << " m, h/d from " << h.first()/largest << " to "
        << h.second()/smallest << endl;
}


bool Foam::printFaults
(
    const grainProperties& properties,
    const nscd::Grains<2>& grains
)
{
    const grainChecks checks(properties, grains);
    const labelList outside(checks.outside());
    const auto overlaps(checks.overlaps(1e-9));
    const auto refused(checks.overlaps(properties.allowedOverlap()));

    scalar worst = 0;
    for (const grainChecks::overlap& o : overlaps)
    {
        worst = max(worst, o.depth);
    }

    Info<< "Outside the mesh        " << outside.size() << " grains";
    if (outside.size())
    {
        Info<< ", the first at "
            << properties.plane().positionInSpace(grains.position[outside[0]]);
    }
    Info<< nl << "Overlaps                " << label(overlaps.size())
        << ", worst " << worst << " m; above 'allowedOverlap' "
        << properties.allowedOverlap() << " of a diameter: "
        << label(refused.size()) << endl;

    return outside.empty() && refused.empty();
}
