// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// ContactDynamics::dumpContactProblem

#include "nscd/dynamics/Implementation.hpp"
#include "nscd/problem/Delassus.hpp"
#include "nscd/problem/Fclib.hpp"

#include <stdexcept>

namespace nscd
{

template <int D>
std::vector<SolvedContact<D>> ContactProblem<D>::solvedContacts(const std::vector<Body<D>>& bodies) const
{
    std::vector<SolvedContact<D>> result;
    const auto add = [&](const auto& c, const Vector<D>& normal, const Vector<D>& armI, const Vector<D>& armJ,
                         const Vector<D>& impulse)
    {
        const bool moves = c.j < candidates_.fixedBody();
        result.push_back({c.i, moves ? c.j : -1, normal, armI, armJ, c.approachLimit, c.friction, impulse,
                          bodies[c.j].velocity});
    };
    for (const Contact<D>& c : contacts_)
    {
        add(c, c.normal, c.normal, -c.normal,
            contactFrame(c.normal).transpose() * impulseVector(c.normal, c.normalImpulse, c.slipImpulse));
    }
    for (const LeveredContact<D>& c : levered_)
    {
        add(c, c.normal(), c.armI, c.armJ, c.impulse);
    }
    return result;
}

template <int D>
void ContactDynamics<D>::Implementation::dumpContactProblem(const std::string& file) const
{
    const std::vector<SolvedContact<D>> solved = communicator_.gather(problem_.solvedContacts(bodies_));
    if (solved.empty())
    {
        throw std::runtime_error(file + ": the last step had no contacts, there is no problem to write");
    }
    if (communicator_.rank() != 0)
    {
        return;
    }
    // bodies in units of their own length, each with its centre at the origin
    std::vector<RigidBody<D>> bodies;
    for (int k = 0; k < candidates_.fixedBody(); ++k)
    {
        const Body<D>& b = bodies_[k];
        const SpinMatrix<D> inverse =
            levered_ ? data_.turning[k].inverse
                     : SpinMatrix<D>(SpinMatrix<D>::Identity() * b.inverseInertia);
        bodies.push_back({Vector<D>::Zero(), b.velocity, toSpin(b.surfaceSpeed), b.inverseMass, inverse});
    }
    std::vector<ContactPoint<D>> contacts;
    FclibSolution<D> solution;
    Vectors<D> backwards;
    for (const SolvedContact<D>& c : solved)
    {
        int second = c.second;
        if (second < 0)
        {
            second = static_cast<int>(bodies.size());
            bodies.push_back({Vector<D>::Zero(), c.wallVelocity, Spin<D>::Zero(), 0, SpinMatrix<D>::Zero()});
        }
        contacts.push_back({c.first, second, c.armI, c.normal, c.approachLimit, c.friction, c.armI - c.armJ});
        solution.r.push_back(c.impulse);
        backwards.push_back(-c.impulse);
    }
    SparseProblem<D> problem = delassus(withImpulses(bodies, contacts, backwards), contacts);
    solution.u = problem.velocities(solution.r);
    writeFclib<D>(file, {std::move(problem), {}, solution});
}

template std::vector<SolvedContact<2>> ContactProblem<2>::solvedContacts(const std::vector<Body<2>>&) const;
template std::vector<SolvedContact<3>> ContactProblem<3>::solvedContacts(const std::vector<Body<3>>&) const;
template void ContactDynamics<2>::Implementation::dumpContactProblem(const std::string&) const;
template void ContactDynamics<3>::Implementation::dumpContactProblem(const std::string&) const;

}  // namespace nscd
