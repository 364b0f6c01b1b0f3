/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactNetwork.H"

#include "addToRunTimeSelectionTable.H"
#include "grainView.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "pointField.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(contactNetwork, 0);
    addToRunTimeSelectionTable(functionObject, contactNetwork, dictionary);
}
}

namespace
{

using namespace Foam;

void writePoint(Ostream& os, const vector& v)
{
    os  << v.x() << ' ' << v.y() << ' ' << v.z() << nl;
}

template<class Value>
void writeScalars
(
    Ostream& os,
    const char* name,
    const char* type,
    const std::vector<grainView::contact>& contacts,
    const Value& value
)
{
    os  << "SCALARS " << name << ' ' << type << " 1" << nl
        << "LOOKUP_TABLE default" << nl;
    for (const grainView::contact& c : contacts)
    {
        os  << value(c) << nl;
    }
}

}


Foam::functionObjects::contactNetwork::contactNetwork
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict)
{}


bool Foam::functionObjects::contactNetwork::write()
{
    const grainView& grains = grainView::of(mesh_, name());
    const std::vector<grainView::contact> contacts(grains.contacts());
    if (!Pstream::master())
    {
        return true;
    }

    pointField points;
    List<labelList> lines;
    for (const grainView::contact& c : contacts)
    {
        labelList line({points.size(), points.size() + 1});
        points.append(grains.centre(c.first));
        points.append(c.place);
        if
        (
            c.second >= 0
         && mag(grains.centre(c.second) - c.place) < 2*grains.radius(c.second)
        )
        {
            line.append(points.size());
            points.append(grains.centre(c.second));
        }
        lines.append(line);
    }

    const fileName dir(time_.globalPath()/"postProcessing"/name());
    mkDir(dir);
    OFstream os(dir/("contacts_" + time_.timeName() + ".vtk"));
    os.precision(10);
    os  << "# vtk DataFile Version 3.0" << nl
        << "contacts at time " << time_.timeName() << nl
        << "ASCII" << nl
        << "DATASET POLYDATA" << nl
        << "POINTS " << points.size() << " double" << nl;
    for (const point& p : points)
    {
        writePoint(os, p);
    }
    os  << "LINES " << lines.size() << ' ' << lines.size() + points.size() << nl;
    for (const labelList& line : lines)
    {
        os  << line.size();
        for (const label i : line)
        {
            os  << ' ' << i;
        }
        os  << nl;
    }

    os  << "CELL_DATA " << lines.size() << nl << "VECTORS force double" << nl;
    for (const grainView::contact& c : contacts)
    {
        writePoint(os, c.force);
    }
    writeScalars
    (
        os, "normal", "double", contacts,
        [](const grainView::contact& c) { return mag(c.force & c.normal); }
    );
    writeScalars
    (
        os, "gap", "double", contacts,
        [](const grainView::contact& c) { return c.gap; }
    );
    if (grains.conducts())
    {
        writeScalars
        (
            os, "heatFlow", "double", contacts,
            [](const grainView::contact& c) { return c.heatFlow; }
        );
    }
    writeScalars
    (
        os, "first", "int", contacts,
        [&](const grainView::contact& c) { return grains.id(c.first); }
    );
    writeScalars
    (
        os, "second", "int", contacts,
        [&](const grainView::contact& c)
        {
            return c.second < 0 ? label(-1) : grains.id(c.second);
        }
    );
    return true;
}
