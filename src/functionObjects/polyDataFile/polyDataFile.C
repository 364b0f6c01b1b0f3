/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polyDataFile.H"

#include "OSspecific.H"

namespace
{

Foam::fileName directory
(
    const Foam::Time& time,
    const Foam::word& functionObject
)
{
    const Foam::fileName dir
    (
        time.globalPath()/"postProcessing"/functionObject
    );
    Foam::mkDir(dir);
    return dir;
}

}


Foam::polyDataFile::polyDataFile
(
    const Time& time,
    const word& functionObject,
    const word& what,
    const word& kind,
    const List<pointField>& cells
)
:
    os_
    (
        directory(time, functionObject)
       /(what + "_" + time.timeName() + ".vtk")
    ),
    size_(cells.size())
{
    label nPoints = 0;
    for (const pointField& points : cells)
    {
        nPoints += points.size();
    }

    os_.precision(10);
    os_ << "# vtk DataFile Version 3.0" << nl
        << what << " at time " << time.timeName() << nl
        << "ASCII" << nl
        << "DATASET POLYDATA" << nl
        << "POINTS " << nPoints << " double" << nl;
    for (const pointField& points : cells)
    {
        for (const point& p : points)
        {
            os_ << p.x() << ' ' << p.y() << ' ' << p.z() << nl;
        }
    }

    os_ << kind << ' ' << size_ << ' ' << size_ + nPoints << nl;
    label next = 0;
    for (const pointField& points : cells)
    {
        os_ << points.size();
        for (label i = 0; i < points.size(); ++i)
        {
            os_ << ' ' << next++;
        }
        os_ << nl;
    }
    os_ << "CELL_DATA " << size_ << nl;
}
