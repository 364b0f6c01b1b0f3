/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactNetwork.H"

#include "addToRunTimeSelectionTable.H"
#include "contactsAreKnown.H"
#include "functionKeywords.H"
#include "grainView.H"
#include "polyDataFile.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(contactNetwork, 0);
    addToRunTimeSelectionTable(functionObject, contactNetwork, dictionary);
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
{
    checkFunctionKeywords(dict, {});
}


bool Foam::functionObjects::contactNetwork::write()
{
    if (!contactsAreKnown(name()))
    {
        return true;
    }

    const grainView& grains = grainView::of(mesh_, name());
    const std::vector<grainView::contact> contacts(grains.contacts());
    if (!Pstream::master())
    {
        return true;
    }

    List<pointField> lines(label(contacts.size()));
    forAll(lines, i)
    {
        const grainView::contact& c = contacts[i];
        lines[i] = pointField({grains.centre(c.first), c.place});
        if
        (
            c.second >= 0
         && mag(grains.centre(c.second) - c.place) < 2*grains.radius(c.second)
        )
        {
            lines[i].append(grains.centre(c.second));
        }
    }

    polyDataFile file(time_, name(), "contacts", "LINES", lines);
    file.vectors("force", [&](label i) { return contacts[i].force; });
    file.scalars
    (
        "normal", "double",
        [&](label i) { return mag(contacts[i].force & contacts[i].normal); }
    );
    file.scalars("gap", "double", [&](label i) { return contacts[i].gap; });
    if (grains.conducts())
    {
        file.scalars
        (
            "heatFlow", "double", [&](label i) { return contacts[i].heatFlow; }
        );
    }
    file.scalars
    (
        "first", "int", [&](label i) { return grains.id(contacts[i].first); }
    );
    file.scalars
    (
        "second", "int",
        [&](label i)
        {
            const label second = contacts[i].second;
            return second < 0 ? label(-1) : grains.id(second);
        }
    );
    return true;
}
