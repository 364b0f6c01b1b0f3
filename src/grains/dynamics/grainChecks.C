/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainChecks.H"

#include "combineOverRanks.H"
#include "dictionaryInput.H"

#include "nscd/shape/Members.hpp"
#include "nscd/search/Neighbours.hpp"
#include "nscd/walls/WallContact.hpp"
#include "OStringStream.H"

#include <algorithm>
#include <limits>
#include <set>

template<int D>
Foam::grainChecks<D>::grainChecks
(
    const grainProperties<D>& properties,
    const nscd::Grains<D>& grains
)
:
    grainChecks
    (
        properties,
        grains,
        dictionaryInput::subDict(properties.dict(), properties.initialName()),
        properties.initialName()
    )
{}


template<int D>
Foam::grainChecks<D>::grainChecks
(
    const grainProperties<D>& properties,
    const nscd::Grains<D>& grains,
    const dictionary& source,
    const word& keyword
)
:
    properties_(properties),
    grains_(grains),
    source_(source),
    keyword_(keyword)
{}


template<int D>
void Foam::grainChecks<D>::refuse(const string& what, const string& allowed) const
{
    FatalIOErrorInFunction(source_)
        << "Keyword '" << keyword_ << "': " << what.c_str() << nl
        << "    allowed: " << allowed.c_str() << exit(FatalIOError);
    std::abort();
}


template<int D>
Foam::string Foam::grainChecks<D>::describe(const label i) const
{
    OStringStream os;
    os  << properties_.one() << ' ' << label(grains_.id[i]) << " at "
        << properties_.space().positionInSpace(grains_.position[i])
        << " with radius " << grains_.radius[i];
    return os.str();
}


template<int D>
Foam::labelList Foam::grainChecks<D>::outside() const
{
    labelList inside(label(grains_.size()));
    forAll(inside, i)
    {
        inside[i] = properties_.space().findCell(grains_.position[i]) >= 0;
    }
    combineOverRanks(inside, maxEqOp<label>());

    DynamicList<label> result;
    forAll(inside, i)
    {
        if (!inside[i])
        {
            result.append(i);
        }
    }
    return labelList(std::move(result));
}


template<int D>
std::vector<typename Foam::grainChecks<D>::overlap> Foam::grainChecks<D>::overlaps
(
    const scalar fraction,
    const std::vector<nscd::WallBody<D>>& bodies
) const
{
    std::vector<overlap> result;
    const nscd::Members<D> members(grains_);
    const std::vector<double>& r = members.radius();
    const nscd::Vectors<D> x
    (
        members.positions(grains_.position, grains_.orientation)
    );
    if (r.empty())
    {
        return result;
    }

    const std::array<double, 3>& period = properties_.contact().period;
    const auto moved = [&](nscd::Vector<D> v, double (*whole)(double))
    {
        for (int d = 0; d < D; ++d)
        {
            v[d] -= period[d] > 0 ? period[d]*whole(v[d]/period[d]) : 0;
        }
        return v;
    };
    nscd::Vectors<D> inBox(x);
    for (nscd::Vector<D>& y : inBox)
    {
        y = moved(y, std::floor);
    }
    const nscd::Neighbours<D> neighbours(inBox, r, 0, period);
    nscd::WallContact<D> walls(properties_.walls().walls(), period);
    walls.place(properties_.walls().bodies(), bodies);

    for (label a = 0; a < label(r.size()); ++a)
    {
        const label i = members.grain(a);

        // Once, though two images may be near
        std::set<label> near;
        neighbours.forNear(a, [&](const label b) { near.insert(b); });
        for (auto b = near.upper_bound(a); b != near.end(); ++b)
        {
            const label j = members.grain(*b);
            const scalar depth =
                r[a] + r[*b] - moved(x[*b] - x[a], std::round).norm();
            if (i != j && depth > 2*fraction*std::min(r[a], r[*b]))
            {
                result.push_back({i, j, depth});
            }
        }

        walls.forNear
        (
            x[a], r[a],
            [&](const label wall)
            {
                const scalar depth = r[a] - walls.distance(wall, x[a]);
                if (depth > 2*fraction*r[a])
                {
                    result.push_back({i, -1, depth});
                }
            }
        );
    }
    return result;
}


template<int D>
void Foam::grainChecks<D>::requireMasses() const
{
    for (std::size_t i = 0; i < grains_.size(); ++i)
    {
        const label m = grains_.material[i];
        const scalar mass =
            properties_.materials().density(m)*properties_.packingRatio()
           *properties_.space().volume(grains_, i);

        // A mesh's depth is written with a finite number of digits
        if (mag(grains_.mass[i] - mass) > 1e-6*mass)
        {
            FatalIOErrorInFunction(properties_.dict())
                << "Keyword 'density' of material "
                << properties_.materials().names()[m] << ": "
                << describe(label(i)).c_str() << " has the mass "
                << grains_.mass[i] << " kg in the state that is continued, "
                << mass << " kg by this dictionary" << nl
                << "    allowed: the density and the packingRatio that the"
                << " state was written with"
                << exit(FatalIOError);
        }
    }
}


template<int D>
void Foam::grainChecks<D>::requireTolerance() const
{
    if (grains_.radius.empty())
    {
        return;
    }
    const scalar diameter =
        2**std::min_element(grains_.radius.begin(), grains_.radius.end());
    scalar farthest = 0;
    for (const nscd::Vector<D>& x : grains_.position)
    {
        farthest = max(farthest, scalar(x.cwiseAbs().maxCoeff()));
    }

    // Above, grains are in each other; below, no solution is accurate enough
    const scalar high = 0.05*diameter;
    const scalar low = std::numeric_limits<scalar>::epsilon()*farthest;
    const scalar tolerance = properties_.contact().tolerance;
    if (tolerance < low || tolerance > high)
    {
        OStringStream allowed;
        allowed
            << "a value from " << low << ", the round-off of positions, to "
            << high << ", a twentieth of the smallest diameter";
        dictionaryInput::badValue
        (
            properties_.dict().subDict("contact"), "tolerance",
            Foam::name(tolerance), allowed.str()
        );
    }
}


template<int D>
void Foam::grainChecks<D>::requireLaws() const
{
    std::set<label> ofGrains(grains_.material.begin(), grains_.material.end());
    std::set<label> others(ofGrains);
    for (const auto& wall : properties_.walls().walls())
    {
        others.insert(nscd::materialOf(wall));
    }
    for (const label a : ofGrains)
    {
        for (const label b : others)
        {
            properties_.materials().checkPair(a, b);
        }
    }
}


template<int D>
void Foam::grainChecks<D>::requireRest() const
{
    for (std::size_t i = 0; properties_.areFixed() && i < grains_.size(); ++i)
    {
        if (grains_.velocity[i].norm() > 0 || grains_.spin[i].norm() > 0)
        {
            OStringStream allowed;
            allowed << "free, or all at rest: " << properties_.one() << ' ' << label(i)
                << " has a velocity of " << grains_.velocity[i].norm() << " m/s";
            dictionaryInput::badValue
            (
                properties_.coupling(), "motion", "fixed", allowed.str()
            );
        }
    }
}


template<int D>
void Foam::grainChecks<D>::requireInside() const
{
    const labelList lost(outside());
    if (lost.size())
    {
        OStringStream allowed;
        allowed << "centres inside the mesh, whose bounding box is "
            << properties_.space().mesh().bounds();
        refuse
        (
            describe(lost[0]) + " is outside the mesh, and so are "
          + Foam::name(lost.size() - 1) + " more",
            allowed.str()
        );
    }
}


template<int D>
void Foam::grainChecks<D>::requireNoOverlap() const
{
    const scalar fraction = properties_.allowedOverlap();
    const std::vector<overlap> found(overlaps(fraction, properties_.walls().bodies()));
    if (found.size())
    {
        const overlap& o = found.front();
        OStringStream what;
        what<< describe(o.first).c_str() << " overlaps "
            << (o.second < 0 ? string("a wall") : describe(o.second)).c_str()
            << " by " << o.depth << " m, and so do "
            << label(found.size() - 1) << " more pairs";
        refuse
        (
            what.str(),
            (properties_.hasAllowedOverlap() ? "up to 'allowedOverlap' = " : "up to ")
          + Foam::name(fraction) + " of the smaller diameter"
        );
    }
}


template class Foam::grainChecks<2>;
template class Foam::grainChecks<3>;
