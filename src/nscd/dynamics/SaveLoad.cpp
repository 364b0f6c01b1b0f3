// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// ContactDynamics::save and load: what the ranks do around one state file.

#include "nscd/dynamics/Implementation.hpp"
#include "nscd/dynamics/RenumberWalls.hpp"
#include "nscd/dynamics/State.hpp"
#include "nscd/dynamics/Validation.hpp"

#include <algorithm>
#include <stdexcept>

namespace nscd
{

namespace
{

template <int D>
void checkState(const State<D>& state, const ContactTable& table, const Settings& settings, std::size_t walls,
                std::size_t wallBodies, const std::string& file)
{
    if (state.wallBodies.size() != wallBodies || state.candidateWalls.size() != wallBodies)
    {
        throw std::runtime_error(file + ": " + std::to_string(state.wallBodies.size()) + " wall bodies instead of " +
                                 std::to_string(wallBodies));
    }
    try
    {
        validate(state.grains, table);
        validate(settings, state.grains);
    }
    catch (const std::invalid_argument& error)
    {
        throw std::runtime_error(file + ": " + error.what());
    }
    auto ids = state.grains.id;
    std::sort(ids.begin(), ids.end());
    const auto twice = std::adjacent_find(ids.begin(), ids.end());
    if (twice != ids.end())
    {
        throw std::runtime_error(file + ": two grains have the id " + std::to_string(*twice));
    }
    for (const NamedImpulse<D>& impulse : state.impulses)
    {
        if (impulse.b < 0 && static_cast<std::size_t>(~impulse.b) >= walls)
        {
            throw std::runtime_error(file + ": a contact with wall " + std::to_string(~impulse.b) + " of " +
                                     std::to_string(walls));
        }
    }
}

/// Turn indices into the state's materials into indices into the table's, by their names.  States and tables without
/// names have the same order.
template <int D>
void renumberMaterials(State<D>& state, const ContactTable& table, const std::string& file)
{
    const std::vector<std::string>& names = table.names();
    if (state.materials.empty() || names.empty())
    {
        return;
    }
    for (std::size_t i = 0; i < state.grains.size(); ++i)
    {
        int& material = state.grains.material[i];
        const std::string grain = file + ": grain " + std::to_string(state.grains.id[i]);
        if (material < 0 || static_cast<std::size_t>(material) >= state.materials.size())
        {
            throw std::runtime_error(grain + " is of material " + std::to_string(material) + " of " +
                                     std::to_string(state.materials.size()));
        }
        const std::string& name = state.materials[material];
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end())
        {
            std::string known;
            for (const std::string& n : names)
            {
                known += ' ' + n;
            }
            throw std::runtime_error(grain + " is of the material " + name + ", which is none of" + known);
        }
        material = static_cast<int>(found - names.begin());
    }
}

/// Run an action that may fail on some ranks only, and let all of them throw if it did.
template <class Action>
void together(const Communicator& communicator, const std::string& file, Action&& action)
{
    std::string message;
    try
    {
        action();
    }
    catch (const std::exception& error)
    {
        message = error.what();
    }
    const bool failed = communicator.max(message.empty() ? 0 : 1) > 0;
    if (failed)
    {
        throw std::runtime_error(message.empty() ? file + ": another rank failed" : message);
    }
}

}  // namespace

template <int D>
void ContactDynamics<D>::Implementation::save(const std::string& file, double time) const
{
    State<D> state;
    state.time = time;
    state.grains = grains_;
    state.materials = table_.names();
    state.contactImpulse = contactImpulse_;
    state.contactSpinImpulse = contactSpinImpulse_;
    state.unexpected = unexpected_;
    state.owed = owed_;
    state.lasting = lasting_;
    state.earlier = earlier_;
    state.lastTimeStep = lastTimeStep_;
    state.lastSubStep = lastSubStep_;
    state.candidatePosition = candidates_.positions();
    state.candidateOrientation = candidates_.orientations();
    state.wallBodies = wallBodies_;
    state.candidateWalls = candidateWalls_;
    state.wallNames = wallNames_;
    state.candidateReach = candidates_.reach();
    state.impulses = gatherImpulses(candidates_, impulses_, communicator_);
    together(communicator_, file,
             [&]
             {
                 if (communicator_.rank() == 0)
                 {
                     writeState(file, state);
                 }
             });
}

template <int D>
void ContactDynamics<D>::Implementation::restoreWalls(const State<D>& state)
{
    for (std::size_t b = 0; b < wallBodies_.size(); ++b)
    {
        wallBodies_[b].position = state.wallBodies[b].position;
        wallBodies_[b].orientation = state.wallBodies[b].orientation;
        wallBodies_[b].velocity = state.wallBodies[b].velocity;
        wallBodies_[b].spin = state.wallBodies[b].spin;
    }
    candidateWalls_ = state.candidateWalls;
    arrangement_.walls().place(initialWallBodies_, candidateWalls_);
}

template <int D>
double ContactDynamics<D>::Implementation::load(const std::string& file)
{
    State<D> state;
    together(communicator_, file,
             [&]
             {
                 state = readState<D>(file);
                 renumberMaterials(state, table_, file);
                 renumberWalls(state, wallNames_, initialWallBodies_, file);
                 checkState(state, table_, settings_, walls_.size(), wallBodies_.size(), file);
             });
    grains_ = std::move(state.grains);
    contactImpulse_ = std::move(state.contactImpulse);
    contactSpinImpulse_ = std::move(state.contactSpinImpulse);
    lastTimeStep_ = state.lastTimeStep;
    const bool isOld = state.lasting.force.size() < grains_.size();
    lasting_ = isOld ? meanOfContacts(lastTimeStep_) : std::move(state.lasting);
    earlier_ = isOld ? lasting_ : std::move(state.earlier);
    unexpected_ = std::move(state.unexpected);
    owed_ = std::move(state.owed);
    for (Wrenches<D>* known : {&unexpected_, &owed_})
    {
        known->force.resize(grains_.size(), Vector<D>::Zero());
        known->torque.resize(grains_.size(), Spin<D>::Zero());
    }
    heaviness_.assign(grains_.size(), 1);
    viscosity_.clear();
    lastSubStep_ = state.lastSubStep;
    measureGrains();
    restoreWalls(state);
    problem_.clear();
    impacts_.clear();
    contactsOfOthers_.clear();
    touching_.clear();
    wallImpulses_.clear();
    rebuildCandidates(state.candidatePosition, state.candidateOrientation, state.candidateReach, state.impulses);
    arrangement_.walls().place(initialWallBodies_, wallBodies_);
    StepReport report;
    measureOverlaps(report);
    return state.time;
}

template void ContactDynamics<2>::Implementation::save(const std::string&, double) const;
template void ContactDynamics<3>::Implementation::save(const std::string&, double) const;
template double ContactDynamics<2>::Implementation::load(const std::string&);
template double ContactDynamics<3>::Implementation::load(const std::string&);

}  // namespace nscd
