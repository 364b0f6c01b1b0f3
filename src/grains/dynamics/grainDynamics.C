/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainDynamics.H"

#include "combineOverRanks.H"
#include "grainChecks.H"
#include "grainState.H"
#include "passablePatches.H"
#include "startOfStep.H"

template<int D>
Foam::grainDynamics<D>::grainDynamics
(
    const fvMesh& mesh,
    const vector& g,
    const grainSet& set
)
:
    grainMotion(mesh, set.name),
    name_(set.name),
    properties_(mesh, g, set),
    injections_(properties_),
    outlets_(properties_, injections_.openings(), name_),
    openings_(outlets_.openings())
{
    properties_.patches().requireMesh();
    const bool restart = continuesFromState(mesh.time(), name_);

    try
    {
        dynamics_.reset
        (
            new nscd::ContactDynamics<D>
            (
                restart ? nscd::Grains<D>() : properties_.initialGrains(),
                properties_.walls().walls(),
                properties_.materials().contactTable(),
                properties_.contact(),
                MPI_COMM_WORLD,
                properties_.walls().bodies()
            )
        );
        dynamics_->setWallNames(properties_.walls().names());
        if (restart)
        {
            dynamics_->load(stateFile());
            Info<< "The " << name_ << " continue from " << stateFile() << endl;
        }
    }
    catch (const std::exception& err)
    {
        FatalIOErrorInFunction(properties_.dict())
            << "Keyword '"
            << (restart ? word("startTime") : properties_.initialName())
            << "': " << err.what() << exit(FatalIOError);
    }

    before_ = grains().position;

    const grainChecks<D> checks(properties_, grains());
    checks.requireTolerance();
    if (!set.changesMasses)
    {
        checks.requireMasses();
    }
    checks.requireLaws();
    asksForVapour_ = properties_.materials().contactTable().asksForAmbient();
    checks.requireRest();
    if (!restart)
    {
        checks.requireInside();
        checks.requireNoOverlap();
    }
    heat_ = grainHeat<D>::New
    (
        properties_.dict(), space(), properties_.materials(), properties_.walls()
    );
    if (heat_)
    {
        heat_->check(grains());
        dynamics_->recordTouching(heat_->hasConductance());
    }

    injections_.check
    (
        heat_.get(),
        std::set<label>(grains().material.begin(), grains().material.end())
    );
    if (!isFixed())
    {
        refuseMirrors(properties_.dict(), mesh);
    }
    printPassablePatches(properties_.dict(), mesh, name_);
    injections_.startAfter(grains());
    if (restart)
    {
        injections_.load(stateFile().path()/"injections");
        outlets_.load(stateFile().path());
    }
    else
    {
        // For pictures that begin with the initial grains
        writeCloud();
    }
}


template<int D>
void Foam::grainDynamics<D>::noteLackOfVapour()
{
    if (asksForVapour_)
    {
        Info<< "'psi0' of a contact law asks for the vapour around grains, and"
            << " there is none: psi is 0" << endl;
        asksForVapour_ = false;
    }
}


template<int D>
template<class Action>
void Foam::grainDynamics<D>::underForces
(
    const vectorField& given,
    const vectorField& givenTorque,
    const scalar deltaT,
    const Action& action
)
{
    noteLackOfVapour();
    nscd::Vectors<D> force(grains().size());
    nscd::Spins<D> torque(grains().size(), nscd::Spin<D>::Zero());

    for (label i = 0; i < size(); ++i)
    {
        const vector weight(grains().mass[i]*properties_.g());
        force[i] = space().fromSpace(given.empty() ? weight : given[i] + weight);
    }
    forAll(givenTorque, i)
    {
        torque[i] = space().spinFromSpace(givenTorque[i]);
    }

    try
    {
        properties_.walls().setMotion
        (
            *dynamics_, startOfStep(mesh().time()), deltaT,
            space().fromSpace(properties_.g())
        );
        action(force, torque);
    }
    catch (const std::exception& err)
    {
        save(".failed");
        FatalErrorInFunction
            << "The contact solver stopped at time "
            << mesh().time().timeName() << ": " << err.what()
            << exit(FatalError);
    }
}


template<int D>
void Foam::grainDynamics<D>::advance
(
    const vectorField& given,
    const vectorField& givenTorque,
    const scalar deltaT
)
{
    underForces
    (
        given, givenTorque, deltaT,
        [&](const nscd::Vectors<D>& force, const nscd::Spins<D>& torque)
        {
            sizeOfStep_ = size();
            before_ = grains().position;
            lastStep_ = dynamics_->step(force, torque, deltaT);
        }
    );
    isLocated_ = false;
}


template<int D>
void Foam::grainDynamics<D>::foresee
(
    const vectorField& fluidForce,
    const scalarField& massOfDrag,
    const scalar deltaT
)
{
    std::vector<double> mass(grains().mass);
    forAll(massOfDrag, i)
    {
        mass[i] += massOfDrag[i];
    }
    underForces
    (
        fluidForce, vectorField(), deltaT,
        [&](const nscd::Vectors<D>& force, const nscd::Spins<D>& torque)
        {
            dynamics_->foresee(mass, force, torque, deltaT);
        }
    );
}


template<int D>
void Foam::grainDynamics<D>::locate() const
{
    if (isLocated_)
    {
        return;
    }
    isLocated_ = true;

    cell_.resize(size(), label(-1));
    labelList found(size());
    forAll(found, i)
    {
        cell_[i] = space().findCell
        (
            properties_.wrapped(grains().position[i]), cell_[i]
        );
        found[i] = cell_[i] >= 0;
    }
    combineOverRanks(found, maxEqOp<label>());

    outside_.resize(size());
    forAll(found, i)
    {
        outside_[i] = !found[i];
    }
}


template<int D>
void Foam::grainDynamics<D>::conduct(const scalar deltaT)
{
    if (heat_)
    {
        dynamics_->setTemperature
        (
            heat_->advance
            (
                grains(), dynamics_->touching(), deltaT,
                dynamics_->wallBodies(), dynamics_->settings().period
            )
        );
    }
}


template<int D>
Foam::List<Foam::grainMember> Foam::grainDynamics<D>::members
(
    const label graini
) const
{
    const nscd::Grains<D>& g = grains();
    if (g.shape[graini] < 0)
    {
        return List<grainMember>(1, grainMember{centre(graini), radius(graini)});
    }
    const nscd::Cluster<D>& cluster = g.clusters[g.shape[graini]];
    List<grainMember> result(label(cluster.centre.size()));
    forAll(result, m)
    {
        const nscd::Vector<D> arm(g.orientation[graini]*cluster.centre[m]);
        result[m].centre = space().positionInSpace
        (
            g.position[graini] + g.radius[graini]*arm
        );
        result[m].radius = g.radius[graini]*cluster.radius[m];
    }
    return result;
}


template<int D>
std::vector<Foam::grainView::contact>
Foam::grainDynamics<D>::contacts() const
{
    std::vector<contact> result;
    for (const nscd::ContactForce<D>& c : dynamics_->contacts())
    {
        result.push_back
        ({
            c.first, max(label(c.second), label(-1)),
            space().positionInSpace(c.point), space().toSpace(c.normal),
            space().toSpace(c.force), space().spinInSpace(c.moment), c.gap,
            heat_ ? heat_->flow(c, grains()) : 0,
            c.second < 0 ? properties_.walls().entry()[~c.second] : -1
        });
    }
    return result;
}


template<int D>
std::vector<Foam::grainView::wallLoad>
Foam::grainDynamics<D>::wallLoads() const
{
    std::vector<wallLoad> result;
    for (const nscd::WallImpulse<D>& c : dynamics_->wallImpulses())
    {
        result.push_back
        ({
            properties_.walls().entry()[c.wall],
            space().positionInSpace(c.point),
            space().toSpace(c.impulse)/lastTimeStep(),
            space().spinInSpace(c.moment)/lastTimeStep()
        });
    }
    return result;
}


template<int D>
Foam::wordList Foam::grainDynamics<D>::wallNames() const
{
    wordList names;
    for (const wallExtent& wall : properties_.walls().extents())
    {
        names.append(wall.name);
    }
    return names;
}


template<int D>
void Foam::grainDynamics<D>::checkInside() const
{
    const label i = outside().find(true);
    if (i >= 0)
    {
        save(".failed");
        FatalErrorInFunction
            << one() << ' ' << id(i) << " at " << centre(i) << " with velocity "
            << velocity(i) << " has left the mesh at time "
            << mesh().time().timeName() << nl
            << "    there is a gap in the walls, or the time step is too large"
            << " for the contact solver (worst overlap "
            << lastStep_.worstOverlap << " m)" << exit(FatalError);
    }
}


template class Foam::grainDynamics<2>;
template class Foam::grainDynamics<3>;
