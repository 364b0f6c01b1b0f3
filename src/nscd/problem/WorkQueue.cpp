// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// ContactProblem::workQueue: effort goes where impulses still change.

#include "nscd/problem/ContactProblem.hpp"

namespace nscd
{

namespace
{

/// Visits after which a group gives way to the others, per contact.
constexpr std::size_t patience = 10;

}  // namespace

template <int D>
void ContactProblem<D>::listTouching(std::size_t bodies)
{
    touchingBegin_.assign(bodies + 1, 0);
    const auto forBoth = [&](auto&& f)
    {
        int id = 0;
        for (const Contact<D>& c : contacts_)
        {
            f(c.i, id);
            f(c.j, id++);
        }
        for (const LeveredContact<D>& c : levered_)
        {
            f(c.i, id);
            f(c.j, id++);
        }
    };
    forBoth([&](int body, int) { ++touchingBegin_[body + 1]; });
    for (std::size_t b = 0; b < bodies; ++b)
    {
        touchingBegin_[b + 1] += touchingBegin_[b];
    }
    touching_.resize(touchingBegin_[bodies]);
    std::vector<int> next(touchingBegin_.begin(), touchingBegin_.end() - 1);
    forBoth([&](int body, int id) { touching_[next[body]++] = id; });
}

template <int D>
template <class F>
void ContactProblem<D>::forTouching(int group, int body, F&& f) const
{
    if (body >= candidates_.fixedBody())
    {
        return;
    }
    const int plain = static_cast<int>(contacts_.size());
    for (int t = touchingBegin_[body]; t < touchingBegin_[body + 1]; ++t)
    {
        const int id = touching_[t];
        const std::size_t k = id < plain ? id : id - plain;
        if (id < plain ? k >= begin_[group].contact && k < begin_[group + 1].contact
                       : k >= begin_[group].levered && k < begin_[group + 1].levered)
        {
            f(id);
        }
    }
}

template <int D>
Change ContactProblem<D>::workQueue(int group, std::vector<Body<D>>& bodies, double tolerance)
{
    if (touchingBegin_.size() != bodies.size() + 1)
    {
        listTouching(bodies.size());
        pending_.assign(contacts(), 0.0);
    }
    const int plain = static_cast<int>(contacts_.size());
    queue_.clear();
    const auto enqueue = [&](int id)
    {
        pending_[id] = -1;
        queue_.push_back(id);
    };
    const double square = tolerance * tolerance;
    for (std::size_t k = begin_[group].contact; k < begin_[group + 1].contact; ++k)
    {
        if (nscd::residual<D>(contacts_[k], bodies.data()) > square)
        {
            enqueue(static_cast<int>(k));
        }
    }
    for (std::size_t k = begin_[group].levered; k < begin_[group + 1].levered; ++k)
    {
        if (nscd::residual<D>(levered_[k], bodies.data()) > square)
        {
            enqueue(plain + static_cast<int>(k));
        }
    }

    const std::size_t limit = patience * (begin_[group + 1].contact - begin_[group].contact +
                                          begin_[group + 1].levered - begin_[group].levered);
    Change change;
    for (std::size_t next = 0; next < queue_.size(); ++next)
    {
        const int id = queue_[next];
        pending_[id] = 0;
        if (change.solves >= limit)
        {
            continue;   // the next visit finds it by its residual
        }
        const auto solveAndPass = [&](auto& contact)
        {
            const double changed = solve<D>(contact, bodies.data());
            change.add(changed);
            const auto notify = [&](int other)
            {
                if (other != id && pending_[other] >= 0)
                {
                    pending_[other] += std::sqrt(changed);
                    if (pending_[other] > tolerance)
                    {
                        enqueue(other);
                    }
                }
            };
            if (changed > 0)
            {
                forTouching(group, contact.i, notify);
                forTouching(group, contact.j, notify);
            }
        };
        if (id < plain)
        {
            solveAndPass(contacts_[id]);
        }
        else
        {
            solveAndPass(levered_[id - plain]);
        }
    }
    return change;
}

template Change ContactProblem<2>::workQueue(int, std::vector<Body<2>>&, double);
template Change ContactProblem<3>::workQueue(int, std::vector<Body<3>>&, double);

}  // namespace nscd
