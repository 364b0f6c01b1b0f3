/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainProperties.H"

#include "dictionaryInput.H"
#include "Enum.H"
#include "meshPeriod.H"

namespace
{

const Foam::Enum<nscd::Solver> solvers
({
    {nscd::Solver::sweeps, "sweeps"},
    {nscd::Solver::queue, "queue"},
    {nscd::Solver::nesterov, "nesterov"}
});

}


template<int D>
Foam::grainProperties<D>::grainProperties
(
    const fvMesh& mesh,
    const vector& g,
    const grainSet& set
)
:
    space_(mesh),
    dict_
    (
        set.properties
      ? inputDictionary(word(set.name + "Properties"), mesh, *set.properties)
      : inputDictionary("grainProperties", mesh)
    ),
    set_(set),
    g_(g),
    materials_(dict_),
    shapes_(dict_, space_),
    walls_
    (
        dictionaryInput::subDict(dict_, "walls"), space_, materials_
    ),
    patchWalls_(dictionaryInput::subDict(dict_, "walls"), space_, walls_),
    contact_(readContact()),
    packingRatio_(readPackingRatio()),
    areFixed_(readFixed()),
    allowedOverlap_
    (
        dictionaryInput::getScalarOrDefault
        (
            dict_, "allowedOverlap", dimless, 0.01, 0
        )
    )
{
    check();
}


template<int D>
void Foam::grainProperties<D>::check() const
{
    dictionaryInput::checkKeywords
    (
        dict_,
        {
            "FoamFile", "shape", "materials", "contactLaws", "walls",
            set_.initial, "allowedOverlap", "contact", "coupling",
            "outlets", "injections", "shapes", "heat"
        }
    );
    if (dict_.found("coupling"))
    {
        dictionaryInput::checkKeywords
        (
            coupling(),
            {
                "packingRatio", "coarseGraining", "motion", "form", "voidFraction",
                "drag", "viscosity", "conductivity", "diffusivity",
                "heatTransfer", "addedMass", "lift", "undisturbedFlow",
                "resolvedGrains", "lubrication"
            }
        );
    }

    const string shape
    (
        string(grainSpace<D>::shape) + ", as this mesh is "
      + (D == 2 ? "two" : "three") + "-dimensional"
    );
    if (dictionaryInput::getAs<word>(dict_, "shape", shape) != grainSpace<D>::shape)
    {
        dictionaryInput::badValue
        (
            dict_, "shape", dictionaryInput::written(dict_, "shape"), shape
        );
    }

    if (!space_.holds(g_))
    {
        FatalErrorInFunction
            << "Keyword 'value' of constant/g has a component across the mesh: "
            << g_ << nl << "    allowed: a vector in the plane of the mesh"
            << exit(FatalError);
    }
    if (cmptMax(cmptMag(g_)) > 1e15)
    {
        FatalErrorInFunction
            << "Keyword 'value' of constant/g has the value " << g_ << nl
            << "    allowed: components of at most 1e15 m/s^2"
            << exit(FatalError);
    }
}


template<int D>
const Foam::dictionary& Foam::grainProperties<D>::coupling() const
{
    return dictionaryInput::subDict(dict_, "coupling");
}


template<int D>
Foam::scalar Foam::grainProperties<D>::readPackingRatio() const
{
    return
        dict_.found("coupling")
      ? dictionaryInput::getScalarOrDefault
        (
            coupling(), "packingRatio", dimless, 1, 0.1, 1
        )
      : 1;
}


template<int D>
bool Foam::grainProperties<D>::readFixed() const
{
    if (!dict_.found("coupling"))
    {
        return false;
    }
    const dictionary& dict = coupling();
    const bool fixed =
        dictionaryInput::getWordOrDefault
        (
            dict, "motion", "free", {"free", "fixed"}
        )
     == "fixed";

    if (fixed && dict_.found("injections"))
    {
        dictionaryInput::badValue
        (
            dict, "motion", "fixed", "free, where 'injections' let grains in"
        );
    }
    return fixed;
}


template<int D>
nscd::Settings Foam::grainProperties<D>::readContact() const
{
    const dictionary& dict = dictionaryInput::subDict(dict_, "contact");

    dictionaryInput::checkKeywords
    (
        dict,
        {"tolerance", "maxSweeps", "maxDisplacement", "blocks", "solver"}
    );

    nscd::Settings settings;
    settings.tolerance =
        dictionaryInput::getPositive(dict, "tolerance", dimLength);
    settings.maxSweeps = dictionaryInput::getLabelOrDefault
    (
        dict, "maxSweeps", settings.maxSweeps, 1
    );
    settings.maxDisplacement = dictionaryInput::getScalarOrDefault
    (
        dict, "maxDisplacement", dimless, settings.maxDisplacement, 1e-6
    );
    settings.blocks = dictionaryInput::getLabelOrDefault
    (
        dict, "blocks", settings.blocks, 1, 1024
    );
    if (settings.blocks & (settings.blocks - 1))
    {
        dictionaryInput::badValue
        (
            dict, "blocks", Foam::name(settings.blocks), "a power of two"
        );
    }
    settings.solver = solvers
    [
        dictionaryInput::getWordOrDefault
        (
            dict, "solver", "sweeps", solvers.names()
        )
    ];

    const nscd::Vector<D> period(space_.fromSpace(meshPeriod(space_.mesh())));
    std::copy(period.data(), period.data() + D, settings.period.begin());
    return settings;
}


template<int D>
nscd::Vector<D> Foam::grainProperties<D>::wrapped(nscd::Vector<D> x) const
{
    const nscd::Vector<D> lower(space_.globalDomain().min());
    for (int d = 0; d < D; ++d)
    {
        x[d] += wrap(x[d], lower[d], contact_.period[d]);
    }
    return x;
}


template<int D>
nscd::Grains<D> Foam::grainProperties<D>::grains(const dictionary& source) const
{
    nscd::Grains<D> result;
    try
    {
        result = grainSource<D>::New
        (
            source, {space_, materials_, shapes_, walls_, contact_, g_}
        )->read();
    }
    catch (const std::exception& err)
    {
        FatalIOErrorInFunction(source)
            << "Keyword '" << source.dictName() << "': " << err.what()
            << exit(FatalIOError);
    }

    for (double& mass : result.mass)
    {
        mass *= packingRatio_;
    }
    // Grains that settle may pass periodic sides
    for (nscd::Vector<D>& x : result.position)
    {
        x = wrapped(x);
    }
    return result;
}


template<int D>
nscd::Grains<D> Foam::grainProperties<D>::initialGrains() const
{
    return grains(dictionaryInput::subDict(dict_, set_.initial));
}


template class Foam::grainProperties<2>;
template class Foam::grainProperties<3>;
