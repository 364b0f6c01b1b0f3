// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Types.hpp"

#include <cmath>
#include <limits>
#include <queue>

/// Smooth discs or spheres of equal mass and radius in a periodic cube, without forces: every collision is at its exact
/// time, in the order of time (Alder and Wainwright 1959, doi:10.1063/1.1730376).  Simple: all pairs of a grain that
/// has collided are looked at.
template <int D>
class EventDriven
{
public:
    EventDriven(nscd::Vectors<D> x, nscd::Vectors<D> v, double radius, double side, double restitution)
        : x_(std::move(x)), v_(std::move(v)), since_(x_.size(), 0.0), collisions_(x_.size(), 0), diameter_(2 * radius),
          side_(side), e_(restitution)
    {
        for (std::size_t i = 0; i < x_.size(); ++i)
        {
            predict(i, i + 1);
        }
    }

    void advance(double time)
    {
        while (!events_.empty() && events_.top().time <= time)
        {
            const Event event = events_.top();
            events_.pop();
            if (collisions_[event.i] == event.ofI && collisions_[event.j] == event.ofJ)
            {
                now_ = event.time;
                event.hit ? collide(event.i, event.j) : predict(event.i, event.j, event.j + 1);
            }
        }
        now_ = time;
    }

    double squareOfSpeeds() const
    {
        double sum = 0;
        for (const auto& v : v_)
        {
            sum += v.squaredNorm();
        }
        return sum;
    }

    const nscd::Vectors<D>& velocities() const { return v_; }
    std::size_t collisions() const { return count_; }

private:
    /// Two grains meet, or have come so far that their images must be looked at anew.
    struct Event
    {
        double time;
        std::size_t i, j;
        int ofI, ofJ;
        bool hit;
        bool operator<(const Event& other) const { return time > other.time; }
    };

    nscd::Vector<D> place(std::size_t i) const { return x_[i] + (now_ - since_[i]) * v_[i]; }

    nscd::Vector<D> separation(std::size_t i, std::size_t j) const
    {
        nscd::Vector<D> y = place(j) - place(i);
        for (double& component : y)
        {
            component -= side_ * std::round(component / side_);
        }
        return y;
    }

    void predict(std::size_t i, std::size_t begin, std::size_t end = std::numeric_limits<std::size_t>::max())
    {
        for (std::size_t j = begin; j < std::min(end, x_.size()); ++j)
        {
            if (j == i)
            {
                continue;
            }
            const nscd::Vector<D> y = separation(i, j), w = v_[j] - v_[i];
            const double fastest = w.cwiseAbs().maxCoeff();
            if (fastest <= 0)
            {
                continue;
            }
            // Until then the nearest image is the one that can be met
            const double valid = (0.5 * side_ - diameter_) / fastest;
            const double yw = y.dot(w), ww = w.squaredNorm();
            const double root = yw * yw - ww * (y.squaredNorm() - diameter_ * diameter_);
            const double after = yw < 0 && root > 0 ? std::max(0.0, (-yw - std::sqrt(root)) / ww) : 2 * valid;
            const bool hit = after < valid;
            events_.push({now_ + (hit ? after : valid), i, j, collisions_[i], collisions_[j], hit});
        }
    }

    void collide(std::size_t i, std::size_t j)
    {
        for (const std::size_t k : {i, j})
        {
            x_[k] = place(k);
            since_[k] = now_;
            ++collisions_[k];
        }
        const nscd::Vector<D> n = separation(i, j).normalized();
        const nscd::Vector<D> impulse = 0.5 * (1 + e_) * (v_[j] - v_[i]).dot(n) * n;
        v_[i] += impulse;
        v_[j] -= impulse;
        ++count_;
        predict(i, 0);
        predict(j, 0);
    }

    nscd::Vectors<D> x_, v_;
    std::vector<double> since_;
    std::vector<int> collisions_;
    double diameter_, side_, e_, now_ = 0;
    std::size_t count_ = 0;
    std::priority_queue<Event> events_;
};
