/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "liquidDroplets.H"


Foam::labelPair Foam::liquidDroplets::touching() const
{
    // The film of gas between them is not resolved, and contacts are closed to the
    // tolerance
    const pointField& x = system_.centres();
    for (label i = 0; i < size(); ++i)
    {
        for (label j = i + 1; j < size(); ++j)
        {
            const scalar Ri = system_.motion().radius(i);
            const scalar Rj = system_.motion().radius(j);
            const scalar gap = 1e-3*min(Ri, Rj) + 3*tolerance_;
            const scalar reach = Ri + Rj + gap;
            if (magSqr(system_.shortest(x[j] - x[i])) < sqr(reach))
            {
                return {i, j};
            }
        }
    }
    return {-1, -1};
}


bool Foam::liquidDroplets::change(List<fate>& fates)
{
    const Time& time = system_.mesh().time();
    const label before = size();
    fates.resize(before);
    forAll(fates, i)
    {
        fates[i] = {i, 1};
    }

    const bool isMore =
        releases_.release(system_, time.value(), time.deltaTValue());
    if (isMore)
    {
        checkNew(before, "releases");
    }

    bool isMerged = false;
    for (labelPair pair(touching()); pair.first() >= 0; pair = touching())
    {
        isMerged = true;
        const label i = pair.first(), j = pair.second();
        const scalar all = mass(i) + mass(j);
        for (fate& f : fates)
        {
            if (f.now == i || f.now == j)
            {
                f.share *= mass(f.now)/all;
                f.now = size() - 2;
            }
            else
            {
                f.now -= (f.now > i) + (f.now > j);
            }
        }

        const label n = system_.mesh().nGeometricD();
        const scalar radius = pow
        (
            pow(system_.motion().radius(i), n) + pow(system_.motion().radius(j), n),
            1.0/n
        );
        Info<< "Droplets " << system_.motion().id(i) << " and "
            << system_.motion().id(j) << " touch and merge" << endl;
        system_.merge(i, j, radius);
    }
    return isMore || isMerged;
}
