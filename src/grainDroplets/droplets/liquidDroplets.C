/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "liquidDroplets.H"

#include "combineOverRanks.H"
#include "dictionaryInput.H"
#include "fvMesh.H"
#include "grainSpace.H"
#include "volFields.H"
#include "Pair.H"


Foam::liquidDroplets::liquidDroplets
(
    const fvMesh& mesh,
    const vector& g,
    const scalar fluidDensity
)
:
    dict_
    (
        IOobject
        (
            "dropletProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    ),
    liquid_(dictionaryInput::subDict(dict_, "liquid"), fluidDensity),
    motionDict_(motionDict(mesh)),
    system_(mesh, g, {"droplets", &motionDict_})
{
    // Masses are their own from now on, not that of their material
    evaporate(scalarField(size(), Zero));
    setFilled(scalarField(mesh.nCells(), Zero));
}


Foam::dictionary Foam::liquidDroplets::motionDict(const fvMesh& mesh) const
{
    dictionaryInput::checkKeywords
    (
        dict_,
        {
            "FoamFile", "liquid", "initialDroplets", "motion", "blowing", "from",
            "walls", "tolerance"
        }
    );

    // As constant/grainProperties has it
    dictionary result(dict_.name());
    result.add("shape", word(isPlanar(mesh) ? "disc" : "sphere"));

    dictionary material, materials;
    material.add("density", liquid_.density);
    materials.add("liquid", material);
    materials.add("wall", material);
    result.add("materials", materials);

    dictionary laws;
    for (const word& other : {"liquid", "wall"})
    {
        dictionary law;
        law.add("materials", Pair<word>("liquid", other));
        law.add("type", word("Coulomb"));
        law.add("friction", 0);
        laws.add(other, law);
    }
    result.add("contactLaws", laws);

    dictionary walls
    (
        dict_.found("walls")
      ? dictionaryInput::subDict(dict_, "walls")
      : dictionary()
    );
    for (const word& name : walls.toc())
    {
        if (walls.isDict(name))
        {
            walls.subDict(name).add("material", word("wall"));
        }
    }
    result.add("walls", walls);

    dictionary initial(dictionaryInput::subDict(dict_, "initialDroplets"));
    initial.add("material", word("liquid"));
    result.add("initialGrains", initial);

    dictionary contact;
    contact.add
    (
        "tolerance",
        dictionaryInput::getPositiveOrDefault
        (
            dict_, "tolerance", dimLength, 1e-7
        )
    );
    result.add("contact", contact);

    dictionary method, coupling;
    method.add("type", word("exactOverlap"));
    coupling.add("voidFraction", method);
    coupling.add
    (
        "motion",
        dictionaryInput::getWordOrDefault
        (
            dict_, "motion", "free", {"free", "fixed"}
        )
    );
    result.add("coupling", coupling);
    return result;
}


Foam::scalar Foam::liquidDroplets::from() const
{
    return dictionaryInput::getScalarOrDefault(dict_, "from", dimless, 4, 2, 100);
}


void Foam::liquidDroplets::setFilled(const scalarField& grains)
{
    const scalarField& V = system_.mesh().V();
    filled_ = scalarField(V.size(), Zero);
    inside_ = scalarField(size(), Zero);
    for (label i = 0; i < size(); ++i)
    {
        for (const cellOverlap& o : system_.overlaps().of(i))
        {
            filled_[o.cell] += o.volume/V[o.cell];
            inside_[i] += o.volume*grains[o.cell];
        }
    }
    sumOverRanks(inside_);
}


void Foam::liquidDroplets::setVolumes
(
    const scalarField& volume,
    const scalarField& mass
)
{
    scalarField radius(size());
    forAll(radius, i)
    {
        radius[i] =
            system_.motion().radius(i)
           *pow
            (
                volume[i]/system_.volume(i),
                1.0/system_.mesh().nGeometricD()
            );
    }
    system_.resize(radius, mass);
}


void Foam::liquidDroplets::evaporate(const scalarField& lost)
{
    scalarField volume(size()), mass(size());
    forAll(volume, i)
    {
        mass[i] = this->mass(i) - lost[i];
        volume[i] = system_.volume(i) - lost[i]/liquid_.density;
    }
    setVolumes(volume, mass);
}


void Foam::liquidDroplets::move
(
    const vectorField& force,
    const vectorField& torque,
    const scalar deltaT
)
{
    system_.move(force, torque, deltaT);
}


void Foam::liquidDroplets::swell(const scalarField& grains)
{
    // Volumes V = V_l + V_in(V) by secants, of which the slope of V_in is that of
    // the last two
    scalarField mass(size()), volume(size()), lastVolume(size());
    scalarField lastInside(size()), slope(size(), Zero);
    forAll(mass, i)
    {
        mass[i] = this->mass(i);
        volume[i] = system_.volume(i);
    }
    for (label iteration = 0; iteration < 50; ++iteration)
    {
        setFilled(grains);
        scalar worst = 0;
        forAll(volume, i)
        {
            if (iteration && mag(volume[i] - lastVolume[i]) > 0)
            {
                slope[i] =
                    (inside_[i] - lastInside[i])/(volume[i] - lastVolume[i]);
                slope[i] = min(max(slope[i], scalar(0)), scalar(0.9));
            }
            const scalar lack =
                mass[i]/liquid_.density + inside_[i] - volume[i];
            worst = max(worst, mag(lack)/volume[i]);
            lastVolume[i] = volume[i];
            lastInside[i] = inside_[i];
            volume[i] += lack/(1 - slope[i]);
        }
        if (worst < 1e-13)
        {
            return;
        }
        setVolumes(volume, mass);
    }
    setFilled(grains);
}


void Foam::liquidDroplets::meshChanged()
{
    system_.meshChanged();
}
