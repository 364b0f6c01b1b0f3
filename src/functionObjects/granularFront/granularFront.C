/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "granularFront.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "functionKeywords.H"
#include "grainView.H"
#include "gravityOf.H"
#include "tableDirectory.H"

#include <cmath>
#include <limits>
#include <numeric>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(granularFront, 0);
    addToRunTimeSelectionTable(functionObject, granularFront, dictionary);
}
}

namespace
{

constexpr Foam::scalar noFront = std::numeric_limits<Foam::scalar>::quiet_NaN();

}


Foam::functionObjects::granularFront::granularFront
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    lastTime_(noFront),
    lastPlace_(noFront)
{
    read(dict);
}


bool Foam::functionObjects::granularFront::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    checkFunctionKeywords(dict, {"origin", "direction", "level", "depth"});

    origin_ = dictionaryInput::getVectorOrZero(dict, "origin");
    const string aVector("a vector that is not zero, as (1 0 0)");
    direction_ = dictionaryInput::getAs<vector>(dict, "direction", aVector);
    if (!(mag(direction_) > 0))
    {
        dictionaryInput::badValue
        (
            dict, "direction", dictionaryInput::written(dict, "direction"),
            aVector
        );
    }
    direction_ /= mag(direction_);
    hasLevel_ = dict.found("level");
    level_ = dictionaryInput::getScalarOrDefault
    (
        dict, "level", dimLength, 0, -GREAT
    );
    depth_ =
        dict.found("depth")
      ? dictionaryInput::getPositive(dict, "depth", dimLength)
      : 0;
    return true;
}


Foam::labelList Foam::functionObjects::granularFront::groups
(
    const grainView& grains
) const
{
    labelList group(grains.size());
    std::iota(group.begin(), group.end(), 0);
    const auto root = [&](label i)
    {
        while (group[i] != i)
        {
            group[i] = group[group[i]];
            i = group[i];
        }
        return i;
    };
    for (const grainView::contact& c : grains.contacts())
    {
        if (c.second >= 0)
        {
            const label i = root(c.first), j = root(c.second);
            group[max(i, j)] = min(i, j);
        }
    }
    forAll(group, i)
    {
        group[i] = root(i);
    }
    return group;
}


bool Foam::functionObjects::granularFront::write()
{
    const grainView& grains = grainView::of(mesh_, name());
    const labelList group(groups(grains));
    if (!Pstream::master())
    {
        return true;
    }

    const vector g(gravityOf(mesh_, name()));
    const vector up(mag(g) > 0 ? vector(-g/mag(g)) : vector(Zero));
    labelList number(group.size(), Zero);
    for (const label i : group)
    {
        ++number[i];
    }
    const label largest = number.empty() ? -1 : findMax(number);

    // fmax passes over nan
    scalar any = noFront, network = noFront, atLevel = noFront;
    forAll(group, i)
    {
        const bool isInNetwork = group[i] == largest && number[largest] > 1;
        for (const grainMember& member : grains.members(i))
        {
            const vector x(member.centre - origin_);
            const scalar place = (x & direction_) + member.radius;
            any = std::fmax(any, place);
            if (isInNetwork)
            {
                network = std::fmax(network, place);
            }
            const scalar off = mag((x & up) - level_);
            if (hasLevel_ && off < member.radius)
            {
                const scalar there =
                    (x & direction_) + std::sqrt(sqr(member.radius) - sqr(off));
                atLevel = std::fmax(atLevel, there);
            }
        }
    }

    if (!file_)
    {
        const fileName dir(tableDirectory(time_, name()));
        file_.reset(new OFstream(dir/"front.csv"));
        file_().precision(12);
        file_() << "time,grains,network,size,level,speed,Froude" << nl;
    }
    const scalar now = time_.value();
    const scalar place = hasLevel_ ? atLevel : network;
    const scalar speed = (place - lastPlace_)/(now - lastTime_);
    file_()
        << now << ',' << any << ',' << network << ','
        << (largest < 0 ? 0 : number[largest]) << ',' << atLevel << ','
        << speed << ','
        << (depth_ > 0 && mag(g) > 0 ? speed/std::sqrt(mag(g)*depth_) : noFront)
        << endl;
    lastTime_ = now;
    lastPlace_ = place;
    return true;
}
