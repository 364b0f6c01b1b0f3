/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "liquidDroplets.H"

#include "volFields.H"
#include "cellSizes.H"
#include "combineOverRanks.H"
#include "dictionaryInput.H"
#include "grainsInDroplets.H"
#include "grainSpace.H"
#include "Pair.H"

Foam::liquidDroplets::liquidDroplets
(
    const fvMesh& mesh,
    const vector& g,
    const scalar fluidDensity
)
:
    dict_("dropletProperties", mesh),
    liquid_(dictionaryInput::subDict(dict_, "liquid"), fluidDensity),
    areCut_
    (
        dictionaryInput::getWordOrDefault
        (
            dict_, "surface", "locked", {"locked", "cutCells"}
        )
     == "cutCells"
    ),
    from_
    (
        dictionaryInput::getScalarOrDefault(dict_, "from", dimless, 4, 2, 100)
    ),
    tolerance_
    (
        dictionaryInput::getPositiveOrDefault
        (
            dict_, "tolerance", dimLength, 1e-7
        )
    ),
    motionDict_(motionDict(mesh)),
    system_(mesh, g, set()),
    releases_
    (
        dict_, system_,
        system_.motion().countOf(motionDict_.subDict("initialDroplets"))
    ),
    crossing_(system_)
{
    if (areCut_ && dict_.found("outlets"))
    {
        dictionaryInput::badValue
        (
            dict_, "surface", "cutCells", "locked, with 'outlets'"
        );
    }
    if (mesh.time().value() <= 0)
    {
        checkNew(0, "initialDroplets");
    }
    // Masses are their own from now on, not that of their material
    lighten(scalarField(size(), Zero));
    inside_ = scalarField(size(), Zero);
    setFilled();
}


void Foam::liquidDroplets::findSmall(const scalar cells)
{
    const scalarField size(cellSizes(system_.mesh()));
    cellSize_ = scalarField(this->size(), Zero);
    scalarField& mean = cellSize_;
    for (label i = 0; i < this->size(); ++i)
    {
        for (const cellOverlap& o : system_.overlaps().of(i))
        {
            mean[i] += o.volume*size[o.cell];
        }
    }
    sumOverRanks(mean);
    const scalarField centres(nCentres());
    isSmall_.resize(this->size());
    forAll(mean, i)
    {
        mean[i] /= max(system_.mappedVolume()[i], VSMALL);

        // As resolvedGrains has it
        isSmall_[i] =
            system_.fluidDiameter(i) < (1 - 1e-6)*cells*mean[i]
         || (!areCut_ && centres[i] == 0);
    }
}


Foam::scalarField Foam::liquidDroplets::nCentres() const
{
    // All ranks make these, whether a droplet is theirs or not
    const vectorField& C = system_.mesh().C();
    const Vector<label>& directions = system_.mesh().geometricD();
    scalarField result(this->size(), Zero);
    for (label i = 0; i < this->size(); ++i)
    {
        for (const cellOverlap& o : system_.overlaps().of(i))
        {
            vector arm(system_.shortest(C[o.cell] - system_.centres()[i]));
            for (direction d = 0; d < vector::nComponents; ++d)
            {
                arm[d] = directions[d] < 0 ? 0 : arm[d];
            }
            result[i] += mag(arm) < system_.motion().radius(i) ? 1 : 0;
        }
    }
    sumOverRanks(result);
    return result;
}


void Foam::liquidDroplets::checkNew(const label first, const word& keyword)
{
    findSmall(from_);
    for (label i = first; i < size(); ++i)
    {
        OStringStream what, allowed;
        if (isSmall_[i])
        {
            what << "has fewer than " << from_ << " cells across";
            allowed
                << "larger droplets, smaller cells, or 'from' of at least 2";
        }
        else if (system_.mappedVolume()[i] < (1 - 1e-6)*system_.volume(i))
        {
            what
                << "is only in part in the mesh, "
                << system_.mappedVolume()[i]/system_.volume(i) << " of it";
            allowed << "droplets that stick out of no wall or patch";
        }
        else if (system_.motion().radius(i) < 10*leastRadius())
        {
            what
                << "has less than ten times the radius at which droplets are"
                << " gone, " << leastRadius() << " m";
            allowed
                << "larger droplets, or a smaller 'tolerance', of which that is"
                << " 20 times";
        }
        if (what.str().size())
        {
            FatalIOErrorInFunction(dict_)
                << "Keyword '" << keyword << "': droplet "
                << system_.motion().id(i) << " at " << system_.centres()[i]
                << " of diameter " << system_.fluidDiameter(i) << " m "
                << what.str().c_str() << nl
                << "    allowed: " << allowed.str().c_str()
                << exit(FatalIOError);
        }
    }
    findSmall(fewest());
}


Foam::grainSet Foam::liquidDroplets::set() const
{
    grainSet result;
    result.name = "droplets";
    result.one = "Droplet";
    result.initial = "initialDroplets";
    result.properties = &motionDict_;
    result.changesMasses = true;
    result.hasAllowedOverlap = false;
    return result;
}


Foam::dictionary Foam::liquidDroplets::motionDict(const fvMesh& mesh) const
{
    dictionaryInput::checkKeywords
    (
        dict_,
        {
            "FoamFile", "liquid", "initialDroplets", "motion", "blowing", "surface",
            "from", "walls", "outlets", "tolerance", "saturation", "releases"
        }
    );

    // As constant/grainProperties has it
    dictionary result(dict_.dictionary::name());
    result.add("shape", word(isPlanar(mesh) ? "disc" : "sphere"));

    dictionary material, materials;
    material.add("density", liquid_.density);
    materials.add("liquid", material);
    materials.add("wall", material);
    result.add("materials", materials);

    dictionary laws;
    for (const char* other : {"liquid", "wall"})
    {
        dictionary law;
        law.add("materials", Pair<word>("liquid", word(other)));
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
    if (dict_.found("outlets"))
    {
        result.add("outlets", dictionaryInput::subDict(dict_, "outlets"));
    }

    result.add
    (
        "initialDroplets", dropletReleases::sourceOf(dict_, "initialDroplets")
    );

    dictionary contact;
    contact.add("tolerance", tolerance_);
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


void Foam::liquidDroplets::setFilled()
{
    const scalarField& V = system_.mesh().V();
    filled_ = scalarField(V.size(), Zero);
    findSmall(fewest());
    for (label i = 0; i < size(); ++i)
    {
        for (const cellOverlap& o : system_.overlaps().of(i))
        {
            filled_[o.cell] += o.volume/V[o.cell];
        }
    }
}


void Foam::liquidDroplets::setInside(grainsInDroplets& grains)
{
    setFilled();
    grains.find();
    inside_ = grains.volume();
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


Foam::scalar Foam::liquidDroplets::leastMass() const
{
    return
        liquid_.density
       *(
            size()
          ? system_.volume(0)
           *pow(leastRadius()/system_.motion().radius(0), system_.mesh().nGeometricD())
          : 0
        );
}


void Foam::liquidDroplets::lighten(const scalarField& lost)
{
    scalarField volume(size()), mass(size());
    lost_ = lost;
    forAll(volume, i)
    {
        volume[i] = system_.volume(i);
        mass[i] = this->mass(i);
        if (lost[i] < mass[i])
        {
            mass[i] -= lost[i];
        }
        else
        {
            lost_[i] = GREAT;
        }
    }
    setVolumes(volume, mass);
}


std::vector<bool> Foam::liquidDroplets::shrink()
{
    std::vector<bool> gone(size(), false);
    scalarField volume(size()), mass(size());
    forAll(volume, i)
    {
        gone[i] = lost_[i] >= GREAT;
        mass[i] = this->mass(i);
        volume[i] =
            system_.volume(i) - (gone[i] ? 0 : lost_[i])/liquid_.density;
    }
    setVolumes(volume, mass);
    return gone;
}


std::vector<bool> Foam::liquidDroplets::remove(const std::vector<bool>& dried)
{
    const std::vector<bool> left(system_.leaving());
    std::vector<bool> gone(dried), others;
    for (label i = 0; i < size(); ++i)
    {
        if (left[i])
        {
            Info<< "Droplet " << system_.motion().id(i)
                << " has left through an outlet, with " << mass(i) << " kg"
                << endl;
            gone[i] = true;
        }
        else
        {
            others.push_back(dried[i]);
        }
    }
    system_.discharge(left);
    system_.remove(others);
    return gone;
}


Foam::Map<Foam::scalarField> Foam::liquidDroplets::move
(
    const vectorField& force,
    const vectorField& torque,
    const scalar deltaT,
    const labelHashSet& freePatches
)
{
    crossing_.startStep(freePatches);
    scalarField liquid(size());
    forAll(liquid, i)
    {
        liquid[i] = 1 - inside_[i]/system_.volume(i);
    }
    system_.move(force, torque, deltaT);
    return crossing_.flux(liquid);
}


void Foam::liquidDroplets::swell(grainsInDroplets& grains)
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
        setInside(grains);
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
    setInside(grains);
}


void Foam::liquidDroplets::meshChanged()
{
    system_.meshChanged();
    setFilled();
}


std::vector<std::pair<const char*, Foam::scalar>>
Foam::liquidDroplets::limits() const
{
    const scalar most = dictionaryInput::getPositiveOrDefault
    (
        system_.mesh().time().controlDict(), "maxDropletCo", dimless, 0.25
    );
    // With the fall from the present speed v: v dt + g dt^2 is the way
    const scalar g = mag(system_.motion().g());
    scalar longest = GREAT;
    for (label i = 0; i < size(); ++i)
    {
        const scalar way = most*cellSize_[i];
        const scalar v = mag(system_.motion().velocity(i));
        longest = min
        (
            longest, 2*way/max(v + std::sqrt(sqr(v) + 4*g*way), VSMALL)
        );
    }
    return {{"maxDropletCo", longest}};
}
