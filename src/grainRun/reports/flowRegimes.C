/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "flowRegimes.H"

#include "couplingOption.H"
#include "recommendedTimeStep.H"

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


template<int D>
void Foam::printFlowRegimes
(
    const grainProperties<D>& properties,
    const nscd::Grains<D>& grains,
    const dragLaw& drag,
    const scalar rho,
    const scalar mu
)
{
    const scalar from =
        couplingOption
        (
            properties.coupling(), "resolvedGrains",
            wordList({"locked", "cutCells"}), {"from", 4, 2, 100}, true
        ).number.value_or(GREAT);

    std::array<flowRegime, 3> regimes
    {{
        {"law, in cells of their size and larger", std::sqrt(2.0)},
        {"law, over several cells", (1 - 1e-6)*from},
        {"resolved", VGREAT}
    }};
    const scalar cell = properties.space().cellSizeRange().first();

    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        const scalar d = properties.lawDiameter(grains.radius[i]);
        const scalar speed = settlingSpeed
        (
            drag, d, properties.materials().density(grains.material[i]), rho,
            mu, mag(properties.g())
        );
        label k = 0;
        while (d >= regimes[k].most*cell)
        {
            ++k;
        }
        regimes[k].add(rho*speed*d/mu);
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
    if (D == 3 && covering.number && covering.Re.first() < creeping)
    {
        WarningInFunction
            << "Where it is alone, a sphere of one and a half cells and more"
            << " that settles at a Reynolds number below " << creeping
            << " is up to a third too fast by a law" << nl
            << "    coupling/resolvedGrains { type locked; from 2; } resolves"
            << " the flow about it; dense beds keep their laws" << endl;
    }
}


template void Foam::printFlowRegimes
(
    const grainProperties<2>&, const nscd::Grains<2>&,
    const dragLaw&, const scalar, const scalar
);
template void Foam::printFlowRegimes
(
    const grainProperties<3>&, const nscd::Grains<3>&,
    const dragLaw&, const scalar, const scalar
);
