/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowRegimes.H"

#include "dictionaryInput.H"
#include "resolvedTerm.H"

#include <array>

namespace Foam
{

// Where spheres settle more than 5 % too fast by their law (doc/theory, table of
// chapter 4)
static constexpr scalar creeping = 5;

struct flowRegime
{
    const char* name;

    // Cells in a diameter that it ends at
    scalar most;

    label number = 0;
    Pair<scalar> Re = {GREAT, 0};

    void add(const scalar grainRe)
    {
        ++number;
        Re.first() = min(Re.first(), grainRe);
        Re.second() = max(Re.second(), grainRe);
    }
};

} // End namespace Foam


void Foam::printFlowRegimes
(
    const dictionary& coupling,
    const UList<settling>& alone,
    const scalar cell,
    const bool areSpheres
)
{
    const word method
    (
        dictionaryInput::subDict(coupling, "voidFraction").get<word>("type")
    );
    const scalar from = resolvedTerm::chosen
    (
        coupling, method == "exactOverlap"
    ).number.value_or(GREAT);

    std::array<flowRegime, 3> regimes
    {{
        {"law, in cells of their size and larger", std::sqrt(2.0)},
        {"law, over several cells", (1 - 1e-6)*from},
        {"resolved", VGREAT}
    }};
    for (const settling& grain : alone)
    {
        label k = 0;
        while (grain.diameter >= regimes[k].most*cell)
        {
            ++k;
        }
        regimes[k].add(grain.Re);
    }

    for (const flowRegime& regime : regimes)
    {
        if (regime.number)
        {
            Info<< "Flow about grains       " << regime.name << ": "
                << regime.number << ", Reynolds numbers of settling "
                << regime.Re.first() << " to " << regime.Re.second() << nl;
        }
    }
    const flowRegime& covering = regimes[1];
    if (areSpheres && covering.number && covering.Re.first() < creeping)
    {
        WarningInFunction
            << "Where it is alone, a sphere of one and a half cells and more"
            << " that settles at a Reynolds number below " << creeping
            << " is up to a third too fast by a law" << nl
            << "    coupling/resolvedGrains { type locked; from 2; } resolves"
            << " the flow about it; dense beds keep their laws" << endl;
    }
}
