// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "Scene.hpp"

#include <algorithm>

/// Random numbers with the distributions that scenes are drawn from.
class Draw
{
public:
    explicit Draw(std::uint64_t seed) : random_(seed) {}

    double uniform(double lower, double upper) { return random_.uniform(lower, upper); }
    double scale(double lower, double upper) { return std::exp(uniform(std::log(lower), std::log(upper))); }
    bool chance(double probability) { return uniform(0, 1) < probability; }
    int below(int n) { return static_cast<int>(uniform(0, n)); }

    template <class T>
    T pick(std::initializer_list<T> values)
    {
        return values.begin()[below(static_cast<int>(values.size()))];
    }

    template <int D>
    nscd::Vector<D> vector(double length)
    {
        nscd::Vector<D> v;
        for (int d = 0; d < D; ++d)
        {
            v[d] = uniform(-length, length);
        }
        return v;
    }

    template <int D>
    nscd::Spin<D> spin(double length)
    {
        nscd::Spin<D> s;
        for (double& component : s)
        {
            component = uniform(-length, length);
        }
        return s;
    }

    template <int D>
    nscd::Vector<D> direction()
    {
        nscd::Vector<D> v = vector<D>(1);
        while (v.norm() < 0.1)
        {
            v = vector<D>(1);
        }
        return v.normalized();
    }

    template <int D>
    nscd::Orientation<D> orientation()
    {
        if constexpr (D == 2)
        {
            return nscd::Orientation<2>(uniform(0, 2 * M_PI));
        }
        else
        {
            return nscd::Orientation<3>(Eigen::AngleAxisd(uniform(0, 2 * M_PI), direction<3>()));
        }
    }

private:
    nscd::Random random_;
};

/// Rods, lumps, a single member, and a body with a member exactly at its centre of mass.
template <int D>
const std::vector<nscd::Cluster<D>>& someClusters()
{
    const auto at = [](double x, double y)
    {
        nscd::Vector<D> v = nscd::Vector<D>::Zero();
        v[0] = x;
        v[1] = y;
        return v;
    };
    static const std::vector<nscd::Cluster<D>> clusters{
        nscd::makeRod<D>(2, 1.5), nscd::makeRod<D>(5, 5), nscd::makeCluster<D>({at(0, 0)}, {1}),
        nscd::makeCluster<D>({at(0, 0), at(1.5, 0), at(-1.5, 0)}, {1, 1, 1}),
        nscd::makeCluster<D>({at(0, 0), at(1.5, 0), at(0, 0.7)}, {1, 1, 0.5}),
        nscd::makeCluster<D>({at(0, 0), at(8, 0)}, {5, 0.2})};
    return clusters;
}

/// A small scene of anything that the library accepts, and what acts on it.
template <int D>
class RandomScene
{
public:
    explicit RandomScene(std::uint64_t seed);

    nscd::ContactDynamics<D> dynamics(MPI_Comm communicator = MPI_COMM_SELF) const
    {
        return {scene.grains, scene.walls, scene.table, scene.settings, communicator, bodies};
    }

    /// Time step, forces and motion of walls for the step to come; new ones on every call.
    void act(nscd::ContactDynamics<D>& dynamics)
    {
        act(std::vector<nscd::ContactDynamics<D>*>{&dynamics});
    }

    void act(const std::vector<nscd::ContactDynamics<D>*>& all);

    /// What is in it, for messages.
    std::string describe() const;

    bool bounces() const { return bounces_; }
    bool coheres() const { return coheres_; }
    bool hasFreeWalls() const { return hasFreeWalls_; }
    bool hasDrivenWalls() const { return hasDrivenWalls_; }
    bool hasClusters() const { return !scene.grains.clusters.empty(); }
    bool isPeriodic() const { return scene.settings.period != std::array<double, 3>{}; }

    Scene<D> scene;
    std::vector<nscd::WallBody<D>> bodies;
    double dt = 0;                 ///< of the step to come [s]
    nscd::Vectors<D> force;        ///< [N]
    nscd::Spins<D> torque;         ///< [N m]

private:
    void addGrains();
    void placeSpecially(std::size_t i);
    void addTable();
    void addSettings();
    void addWalls();
    void addFacets(int body);
    void addBody();
    int someBody() { return bodies.empty() || draw_.chance(0.4) ? -1 : draw_.below(static_cast<int>(bodies.size())); }

    Draw draw_;
    bool bounces_ = false, coheres_ = false, hasFreeWalls_ = false, hasDrivenWalls_ = false;
    double largest_ = 0, side_ = 0;    ///< radius; of the box that grains start in [m]
    double usualStep_ = 0, speed_ = 0;
    nscd::Vector<D> gravity_ = nscd::Vector<D>::Zero();
    double kicks_ = 0;                 ///< random acceleration [m/s^2]
};

template <int D>
RandomScene<D>::RandomScene(std::uint64_t seed) : draw_(seed)
{
    addGrains();
    addTable();
    addSettings();
    addWalls();
}

template <int D>
std::string RandomScene<D>::describe() const
{
    std::string text = std::to_string(D) + "-D, " + std::to_string(scene.grains.size()) + " grains, " +
                       std::to_string(scene.walls.size()) + " walls, " + std::to_string(scene.settings.maxSweeps) +
                       " sweeps of solver " + std::to_string(static_cast<int>(scene.settings.solver));
    const auto add = [&text](bool is, const char* what) { text += is ? std::string(", ") + what : ""; };
    add(hasClusters(), "clusters");
    add(hasFreeWalls_, "free walls");
    add(hasDrivenWalls_, "driven walls");
    add(isPeriodic(), "periodic");
    add(bounces_, "bouncing");
    add(coheres_, "cohesion");
    add(scene.table(0, 0).rolling > 0, "rolling resistance");
    add(kicks_ > 0, "random forces");
    add(gravity_.norm() > 0, "gravity");
    return text;
}

template <int D>
void RandomScene<D>::addGrains()
{
    const double unit = draw_.pick({1e-3, 1.0, 30.0});
    const double ratio = draw_.pick({1.0, 1.0, 2.0, 10.0, 100.0});
    const double heavier = draw_.pick({1.0, 1.0, 1e2, 1e6});
    const bool clusters = draw_.chance(0.35);
    const int n = 1 + draw_.below(draw_.pick({2, 5, 15, 30}));
    usualStep_ = draw_.scale(1e-5, 1e-1);
    speed_ = unit / usualStep_ * (draw_.chance(0.04) ? draw_.scale(1, 1e3) : draw_.scale(1e-4, 1));
    speed_ = draw_.chance(0.1) ? 0 : speed_;

    double volume = 0;
    std::vector<double> radius;
    for (int i = 0; i < n; ++i)
    {
        radius.push_back(unit * draw_.scale(1 / ratio, 1));
        largest_ = std::max(largest_, radius.back());
        volume += std::pow(2 * radius.back(), D);
    }
    side_ = std::pow(volume, 1.0 / D) * draw_.uniform(0.8, 2.5);
    if (clusters)
    {
        scene.grains.clusters = someClusters<D>();
    }
    for (std::size_t i = 0; i < radius.size(); ++i)
    {
        const double mass = 1e3 * std::pow(radius[i], D) * draw_.scale(1 / std::sqrt(heavier), std::sqrt(heavier));
        const nscd::Vector<D> x = nscd::Vector<D>::Constant(side_ / 2) + draw_.vector<D>(side_ / 2);
        scene.add(x, draw_.vector<D>(speed_), radius[i], mass);
        scene.grains.spin[i] = draw_.spin<D>(draw_.chance(0.5) ? speed_ / radius[i] : 0);
        if (clusters && draw_.chance(0.7))
        {
            scene.grains.shape[i] = draw_.below(static_cast<int>(scene.grains.clusters.size()));
            scene.grains.orientation[i] = draw_.orientation<D>();
        }
        scene.grains.material[i] = draw_.below(2);
        placeSpecially(i);
    }
    const double push = unit / (usualStep_ * usualStep_);
    gravity_ = draw_.chance(0.5) ? nscd::Vector<D>(draw_.direction<D>() * push * draw_.scale(1e-6, 0.1)) : gravity_;
    kicks_ = draw_.chance(0.3) ? push * draw_.scale(1e-6, 1e-2) : 0;
}

/// On the centre of another grain, or just in touch with it.
template <int D>
void RandomScene<D>::placeSpecially(std::size_t i)
{
    nscd::Grains<D>& grains = scene.grains;
    if (i == 0 || draw_.chance(0.7))
    {
        return;
    }
    const std::size_t other = draw_.below(static_cast<int>(i));
    const nscd::Vector<D> along = draw_.chance(0.5) ? nscd::Vector<D>(nscd::Vector<D>::Unit(draw_.below(D)))
                                                    : draw_.direction<D>();
    const double distance = draw_.chance(0.1) ? 0 : grains.radius[i] + grains.radius[other];
    grains.position[i] = grains.position[other] + distance * along;
    grains.velocity[i] = draw_.chance(0.3) ? grains.velocity[other] : grains.velocity[i];
}

template <int D>
void RandomScene<D>::addTable()
{
    scene.table = nscd::ContactTable(2);
    const bool bounces = draw_.chance(0.3), coheres = draw_.chance(0.2), rolls = draw_.chance(0.3);
    for (int a = 0; a < 2; ++a)
    {
        for (int b = a; b < 2; ++b)
        {
            nscd::ContactParameters law;
            law.friction = draw_.pick({0.0, 0.3, 1.0, draw_.uniform(0, 3)});
            law.restitution = bounces ? draw_.pick({0.0, 1.0, draw_.uniform(0, 1)}) : 0;
            law.rolling = rolls ? draw_.scale(1e-3, 2) : 0;
            if (coheres)
            {
                const double scale = 1e3 * std::pow(largest_, D + 1) / (usualStep_ * usualStep_);
                law.cohesion = draw_.chance(0.7) ? scale * draw_.scale(1e-6, 1e-2) : 0;
                law.tension = draw_.chance(0.7) ? scale / largest_ * draw_.scale(1e-6, 1e-2) : 0;
                law.cohesionDelay = draw_.chance(0.3) ? usualStep_ * draw_.uniform(0, 5) : 0;
            }
            bounces_ = bounces_ || law.restitution > 0;
            coheres_ = coheres_ || law.cohesion > 0 || law.tension > 0;
            scene.table.set(a, b, law);
        }
    }
}

template <int D>
void RandomScene<D>::addBody()
{
    nscd::WallBody<D> body;
    body.position = nscd::Vector<D>::Constant(side_ / 2) + draw_.vector<D>(side_);
    if (draw_.chance(0.5))
    {
        body.mass = 1e3 * std::pow(largest_, D) * draw_.scale(1e-2, 1e2);
        const double inertia = body.mass * side_ * side_ * draw_.scale(0.1, 10);
        body.inertia = draw_.chance(0.5) ? nscd::Spin<D>(nscd::Spin<D>::Constant(inertia)) : body.inertia;
        hasFreeWalls_ = true;
    }
    else
    {
        hasDrivenWalls_ = true;
    }
    body.velocity = draw_.vector<D>(speed_);
    bodies.push_back(body);
}

template <int D>
void RandomScene<D>::addWalls()
{
    if (draw_.chance(0.35))
    {
        return;
    }
    for (int n = draw_.chance(0.5) ? 0 : 1 + draw_.below(2); n > 0; --n)
    {
        addBody();
    }
    if (draw_.chance(0.6))
    {
        scene.addBox(nscd::Vector<D>::Constant(side_));
        if constexpr (D == 3)
        {
            const auto crosses = [this](const auto& wall)   // a periodic direction
            {
                const nscd::Vector<3>& normal = std::get<nscd::Plane>(wall).normal;
                const auto& period = scene.settings.period;
                return normal.dot(nscd::Vector<3>(period[0], period[1], period[2])) != 0;
            };
            scene.walls.erase(std::remove_if(scene.walls.begin(), scene.walls.end(), crosses), scene.walls.end());
        }
    }
    if (scene.walls.empty() || draw_.chance(0.5))
    {
        for (int parts = 1 + draw_.below(3); parts > 0; --parts)
        {
            addFacets(someBody());
        }
    }
}

/// A chain of segments, or a fan of triangles, some of them slivers; shorter than the period of a periodic box.
template <int D>
void RandomScene<D>::addFacets(int body)
{
    const nscd::Vector<D> middle = nscd::Vector<D>::Constant(side_ / 2) + draw_.vector<D>(isPeriodic() ? side_ / 2 : 0);
    const double extent = isPeriodic() ? 0.1 * side_ : side_;
    const auto point = [&] { return nscd::Vector<D>(middle + draw_.vector<D>(extent)); };
    nscd::Vector<D> a = point(), b = point();
    const nscd::Vector<D> hub = a;
    for (int facets = 1 + draw_.below(4); facets > 0; --facets)
    {
        nscd::Vector<D> c = point();
        if (draw_.chance(0.3))
        {
            c = b + draw_.uniform(0.1, 1) * (b - a);   // straight on
            c += draw_.direction<D>() * (extent * draw_.scale(1e-8, 1e-1));
        }
        if constexpr (D == 2)
        {
            scene.walls.push_back({a, b, draw_.below(2), body});
            a = b;
        }
        else
        {
            scene.walls.push_back(nscd::Triangle{hub, b, c, draw_.below(2), body});
        }
        b = c;
    }
}

template <int D>
void RandomScene<D>::addSettings()
{
    scene.settings.tolerance = largest_ * draw_.scale(1e-12, 1e-3);
    scene.settings.maxSweeps = draw_.pick({1, 5, 50, 200, 1000});
    scene.settings.blocks = draw_.pick({1, 2, 8, 64});
    scene.settings.solver = draw_.pick({nscd::Solver::sweeps, nscd::Solver::queue, nscd::Solver::nesterov});
    scene.settings.maxDisplacement = draw_.pick({0.5, 0.5, 0.1, 2.0});
    for (int d = 0; d < D && draw_.chance(0.3); ++d)
    {
        scene.settings.period[d] = std::max(side_, 8.5 * largest_);
        scene.settings.maxDisplacement = 0.5;   // further, and grains meet by another image than at first
    }
}

template <int D>
void RandomScene<D>::act(const std::vector<nscd::ContactDynamics<D>*>& all)
{
    const nscd::Grains<D>& grains = scene.grains;
    dt = usualStep_ * (draw_.chance(0.2) ? draw_.uniform(0.2, 1.5) : 1);
    force.clear();
    torque.assign(grains.size(), nscd::Spin<D>::Zero());
    for (const double mass : grains.mass)
    {
        force.push_back(mass * (gravity_ + draw_.vector<D>(kicks_)));
    }
    for (std::size_t b = 0; b < bodies.size(); ++b)
    {
        if (!draw_.chance(0.1))
        {
            continue;
        }
        const bool isFree = std::isfinite(bodies[b].mass);
        const bool turns = isFree ? std::isfinite(bodies[b].inertia[0]) : draw_.chance(0.5);
        const nscd::Vector<D> v = draw_.vector<D>(1);
        const nscd::Spin<D> s = draw_.spin<D>(turns ? 1 : 0);
        for (nscd::ContactDynamics<D>* dynamics : all)
        {
            if (isFree)
            {
                const double push = bodies[b].mass * 0.1 * speed_ / usualStep_;
                dynamics->setWallLoad(static_cast<int>(b), push * v, push * side_ * s);
            }
            else
            {
                dynamics->setWallMotion(static_cast<int>(b), speed_ * v, speed_ / side_ * s);
            }
        }
    }
}
