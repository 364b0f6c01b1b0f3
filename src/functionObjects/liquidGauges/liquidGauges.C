/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "liquidGauges.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "functionKeywords.H"
#include "gravityOf.H"
#include "ListOps.H"
#include "tableDirectory.H"
#include "volFields.H"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(liquidGauges, 0);
    addToRunTimeSelectionTable(functionObject, liquidGauges, dictionary);
}
}

namespace
{

constexpr Foam::scalar dry = std::numeric_limits<Foam::scalar>::quiet_NaN();

}


Foam::functionObjects::liquidGauges::liquidGauges
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict)
{
    read(dict);
}


bool Foam::functionObjects::liquidGauges::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    checkFunctionKeywords(dict, {"stations", "alpha", "origin", "thickness"});

    alphaName_ = dict.getOrDefault<word>("alpha", "alpha.water");
    if (!postProcess && !mesh_.foundObject<volScalarField>(alphaName_))
    {
        dictionaryInput::badValue
        (
            dict, "alpha", alphaName_,
            "the name of a field of the solver, as alpha.water"
        );
    }
    origin_ = dictionaryInput::getVectorOrZero(dict, "origin");
    thickness_ = dictionaryInput::getScalarOrDefault
    (
        dict, "thickness", dimLength, 0, 0
    );
    const string points("a list of points in the mesh, as ((0.5 0 0) (1 0 0))");
    const pointField last(stations_);
    stations_ = dictionaryInput::getAs<List<point>>(dict, "stations", points);
    if (last.size() && last != stations_)
    {
        WarningInFunction
            << "Function object " << name() << " has other stations now; its tables"
            << " go on with those of the start: others need a function object of"
            << " their own" << endl;
        stations_ = last;
    }
    if (stations_.empty())
    {
        dictionaryInput::badValue(dict, "stations", "()", points);
    }
    const vector up(-normalised(gravityOf(mesh_, name())));
    findLines(up);
    forAll(lines_, i)
    {
        if (returnReduce(lines_[i].size(), sumOp<label>()) == 0)
        {
            OStringStream os;
            os << stations_[i];
            dictionaryInput::badValue
            (
                dict, "stations", os.str(),
                points + "; the vertical line through this one passes no cell"
            );
        }
    }
    return true;
}


void Foam::functionObjects::liquidGauges::findLines(const vector& up)
{
    lines_.resize(stations_.size());
    forAll(lines_, i)
    {
        lines_[i] = cellOnLine::list(mesh_, stations_[i], up);
    }
}


Foam::List<Foam::functionObjects::liquidGauges::part>
Foam::functionObjects::liquidGauges::parts
(
    const label stationi,
    const vector& up
) const
{
    const auto& alpha = mesh_.lookupObject<volScalarField>(alphaName_);
    const auto* eps = mesh_.cfindObject<volScalarField>("eps");

    // Four numbers for each part, as ranks send them
    List<scalarList> all(Pstream::nProcs());
    scalarList& mine = all[Pstream::myProcNo()];
    mine.resize(4*lines_[stationi].size());
    const scalar base = (stations_[stationi] - origin_) & up;
    forAll(lines_[stationi], k)
    {
        const cellOnLine& c = lines_[stationi][k];
        const scalar share = alpha[c.cell];
        mine[4*k] = base + c.begin;
        mine[4*k + 1] = base + c.end;
        mine[4*k + 2] = share;
        mine[4*k + 3] = share*(eps ? (*eps)[c.cell] : 1);
    }
    Pstream::gatherList(all);

    DynamicList<part> found;
    if (Pstream::master())
    {
        for (const scalarList& one : all)
        {
            for (label k = 0; k < one.size(); k += 4)
            {
                found.append({one[k], one[k + 1], one[k + 2], one[k + 3]});
            }
        }
    }
    std::sort
    (
        found.begin(), found.end(),
        [](const part& a, const part& b) { return a.begin < b.begin; }
    );

    return List<part>(std::move(found));
}


Foam::scalar Foam::functionObjects::liquidGauges::level
(
    const UList<part>& parts
)
{
    label top = parts.size() - 1;
    while (top >= 0 && parts[top].share < 0.5)
    {
        --top;
    }
    if (top < 0)
    {
        return dry;
    }
    const label low = max(top - 3, 0);
    const label high = min(top + 3, parts.size() - 1);
    scalar result = parts[low].begin;
    for (label k = low; k <= high; ++k)
    {
        result +=
            min(max(parts[k].share, scalar(0)), scalar(1))
           *(parts[k].end - parts[k].begin);
    }
    return result;
}


void Foam::functionObjects::liquidGauges::openFiles()
{
    const fileName dir(tableDirectory(time_, name()));
    for (const word file : {"levels", "thicknesses", "runUp"})
    {
        files_.append(new OFstream(dir/file + ".csv"));
        files_.last().precision(12);
        files_.last() << "time";
    }
    for (label filei = 0; filei < 2; ++filei)
    {
        forAll(stations_, i)
        {
            files_[filei] << ",station" << i;
        }
    }
    files_[2] << ",runUp,film";
    for (OFstream& file : files_)
    {
        file << nl;
    }
}


bool Foam::functionObjects::liquidGauges::write()
{
    const vector up(-normalised(gravityOf(mesh_, name())));
    if (lines_.empty())
    {
        findLines(up);
    }
    if (Pstream::master() && files_.empty())
    {
        openFiles();
    }

    scalarList levels(stations_.size()), thicknesses(stations_.size(), Zero);
    scalar runUp = dry, film = dry;
    forAll(stations_, i)
    {
        const List<part> line(parts(i, up));
        levels[i] = level(line);
        for (const part& p : line)
        {
            thicknesses[i] += p.liquid*(p.end - p.begin);
        }
        // It passes over nan
        film = std::fmax(film, levels[i]);
        if (thicknesses[i] >= thickness_)
        {
            runUp = std::fmax(runUp, levels[i]);
        }
    }
    if (!Pstream::master())
    {
        return true;
    }
    for (OFstream& file : files_)
    {
        file << time_.value();
    }
    forAll(stations_, i)
    {
        files_[0] << ',' << levels[i];
        files_[1] << ',' << thicknesses[i];
    }
    files_[2] << ',' << runUp << ',' << film;
    for (OFstream& file : files_)
    {
        file << endl;
    }
    return true;
}
