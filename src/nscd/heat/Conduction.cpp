// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/heat/Conduction.hpp"

#include "nscd/base/Check.hpp"
#include "nscd/heat/ContactPatch.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace nscd
{

namespace
{

/// Radius of a grain's surface where it touches [m]: a cluster's is that of the member whose surface is nearest.
template <int D>
double radiusAt(const Grains<D>& grains, int grain, const Vector<D>& point)
{
    const double radius = grains.radius[grain];
    if (grains.shape[grain] < 0)
    {
        return radius;
    }
    const Cluster<D>& cluster = grains.clusters[grains.shape[grain]];
    const Eigen::Matrix<double, D, D> toBody = grains.orientation[grain].toRotationMatrix().transpose();
    const Vector<D> x = toBody * (point - grains.position[grain]) / radius;
    double nearest = std::numeric_limits<double>::infinity(), found = radius;
    for (std::size_t i = 0; i < cluster.centre.size(); ++i)
    {
        const double distance = std::abs((cluster.centre[i] - x).norm() - cluster.radius[i]);
        if (distance < nearest)
        {
            nearest = distance;
            found = radius * cluster.radius[i];
        }
    }
    return found;
}

void checkIndex(int index, std::size_t size, const char* owner, std::size_t number, const char* what)
{
    if (index < 0 || static_cast<std::size_t>(index) >= size)
    {
        refuse("conduction: ", owner, ' ', number, ": ", what, ' ', index, " is not one of ", size);
    }
}

}  // namespace

template <int D>
Conduction<D>::Conduction(std::vector<ThermalMaterial> materials, double length, ConductanceLaw law)
    : materials_(std::move(materials)), length_(length), law_(std::move(law))
{
    for (std::size_t i = 0; i < materials_.size(); ++i)
    {
        const ThermalMaterial& m = materials_[i];
        if (!isPositive(m.conductivity))
        {
            refuse("conduction: material ", i, ": conductivity ", m.conductivity, " W/m/K is not positive");
        }
        if (!isPositive(m.youngsModulus))
        {
            refuse("conduction: material ", i, ": Young's modulus ", m.youngsModulus, " Pa is not positive");
        }
        if (!std::isfinite(m.poissonRatio) || m.poissonRatio <= -1 || m.poissonRatio > 0.5)
        {
            refuse("conduction: material ", i, ": Poisson ratio ", m.poissonRatio, " is not within (-1, 0.5]");
        }
    }
    if (!isPositive(length))
    {
        refuse("conduction: length ", length, " m of the grains is not positive");
    }
}

template <int D>
ThermalContact Conduction<D>::thermalContact(int first, int second, const Vector<D>& point, const Grains<D>& grains,
                                             const std::vector<ThermalWall>& walls) const
{
    const bool isWall = second < 0;
    const int other = isWall ? walls[~second].material : grains.material[second];
    return {materials_[grains.material[first]], materials_[other], radiusAt<D>(grains, first, point),
            isWall ? std::numeric_limits<double>::infinity() : radiusAt<D>(grains, second, point), 0, length_};
}

template <int D>
double Conduction<D>::conductance(const ContactForce<D>& contact, const Grains<D>& grains,
                                  const std::vector<ThermalWall>& walls) const
{
    ThermalContact c = thermalContact(contact.first, contact.second, contact.point, grains, walls);
    c.force = contact.pressing;
    return law_(c);
}

template <int D>
double Conduction<D>::conductance(const Touching<D>& touching, const Grains<D>& grains,
                                  const std::vector<ThermalWall>& walls, double dt, double joined) const
{
    if (!(touching.pressed > 0))
    {
        return 0;
    }
    ThermalContact c = thermalContact(touching.first, touching.second, touching.point, grains, walls);
    if (touching.impacts == 0)
    {
        c.force = joined * touching.pressed / touching.time;
        return law_(c) / joined * touching.time / dt;
    }
    const double other = touching.second < 0 ? std::numeric_limits<double>::infinity() : grains.mass[touching.second];
    const double mass = 1 / (1 / grains.mass[touching.first] + 1 / other);
    const double impulse = touching.pressed / touching.impacts;
    const ThermalImpact impact =
        D == 2 ? impactOfCylinders(c, mass, impulse, law_) : impactOfSpheres(c, mass, impulse, law_);
    return touching.impacts * impact.conducted / dt;
}

template <int D>
double Conduction<D>::heatFlow(const ContactForce<D>& contact, const Grains<D>& grains,
                               const std::vector<ThermalWall>& walls) const
{
    const double first = grains.temperature[contact.first];
    const double second = contact.second < 0 ? walls[~contact.second].temperature.value_or(first)
                                             : grains.temperature[contact.second];
    return conductance(contact, grains, walls) * (first - second);
}

template <int D>
Heated Conduction<D>::advance(const Grains<D>& grains, const std::vector<double>& heatCapacity,
                              const std::vector<ContactForce<D>>& contacts, const std::vector<ThermalWall>& walls,
                              double dt) const
{
    if (!isPositive(dt))
    {
        refuse("conduction: time step ", dt, " s is not positive");
    }
    const HeatNetwork joined(network(grains, heatCapacity, contacts, walls));
    Heated heated{grains.temperature, std::vector<double>(walls.size(), 0.0)};
    joined.advance(heated.temperature, heated.wallHeat, dt);
    return heated;
}

template <int D>
HeatNetwork Conduction<D>::network(const Grains<D>& grains, const std::vector<double>& heatCapacity,
                                   const std::vector<ContactForce<D>>& contacts,
                                   const std::vector<ThermalWall>& walls) const
{
    return join(grains, heatCapacity, contacts, walls,
                [](const ContactForce<D>& contact) { return std::pair(contact.pressing, contact.pressing); },
                [&](ContactForce<D> contact, double joined)
                {
                    contact.pressing *= joined;
                    return conductance(contact, grains, walls) / joined;
                });
}

template <int D>
HeatNetwork Conduction<D>::network(const Grains<D>& grains, const std::vector<double>& heatCapacity,
                                   const std::vector<Touching<D>>& touching, const std::vector<ThermalWall>& walls,
                                   double dt) const
{
    return join(grains, heatCapacity, touching, walls,
                [&](const Touching<D>& pair)
                {
                    return pair.impacts == 0 ? std::pair(pair.pressed / pair.time, pair.pressed / dt)
                                             : std::pair(0.0, 0.0);
                },
                [&](const Touching<D>& pair, double joined)
                { return conductance(pair, grains, walls, dt, joined); });
}

template <int D>
void Conduction<D>::check(const Grains<D>& grains, const std::vector<double>& heatCapacity,
                          const std::vector<ThermalWall>& walls) const
{
    if (heatCapacity.size() != grains.size())
    {
        refuse("conduction: ", grains.size(), " grains but ", heatCapacity.size(), " heat capacities");
    }
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        checkIndex(grains.material[i], materials_.size(), "grain", i, "material");
        if (!isPositive(heatCapacity[i]))
        {
            refuse("conduction: grain ", i, ": heat capacity ", heatCapacity[i], " J/K is not positive");
        }
        if (!isPositive(grains.temperature[i]))
        {
            refuse("conduction: grain ", i, ": temperature ", grains.temperature[i], " K is not positive");
        }
    }
    for (std::size_t w = 0; w < walls.size(); ++w)
    {
        checkIndex(walls[w].material, materials_.size(), "wall", w, "material");
        if (walls[w].temperature && !isPositive(*walls[w].temperature))
        {
            refuse("conduction: wall ", w, ": temperature ", *walls[w].temperature, " K is not positive");
        }
    }
}

template <int D>
template <class Pair, class ForceOf, class ConductanceOf>
HeatNetwork Conduction<D>::join(const Grains<D>& grains, const std::vector<double>& heatCapacity,
                                const std::vector<Pair>& pairs, const std::vector<ThermalWall>& walls,
                                ForceOf&& forceOf, ConductanceOf&& conductanceOf) const
{
    check(grains, heatCapacity, walls);
    std::vector<std::size_t> onWalls;
    std::vector<ContactPatch<D>> patches;
    for (std::size_t c = 0; c < pairs.size(); ++c)
    {
        const Pair& pair = pairs[c];
        checkIndex(pair.first, grains.size(), "contact", c, "grain");
        const int wall = ~pair.second;
        if (wall < 0)
        {
            checkIndex(pair.second, grains.size(), "contact", c, "grain");
        }
        else
        {
            checkIndex(wall, walls.size(), "contact", c, "wall");
            ThermalContact contact = thermalContact(pair.first, pair.second, pair.point, grains, walls);
            const auto [force, meanForce] = forceOf(pair);
            if (force > 0)
            {
                contact.force = force;
                const double radius = D == 2 ? hertzHalfWidth(contact) : hertzRadius(contact);
                patches.push_back({pair.first, wall, pair.point, radius, force, meanForce});
                onWalls.push_back(c);
            }
        }
    }
    std::vector<double> joined(pairs.size(), 1.0);
    const std::vector<double> factors = joinedForces(patches);
    for (std::size_t i = 0; i < factors.size(); ++i)
    {
        joined[onWalls[i]] = factors[i];
    }
    HeatNetwork network(heatCapacity);
    for (std::size_t c = 0; c < pairs.size(); ++c)
    {
        const Pair& pair = pairs[c];
        const int wall = ~pair.second;
        const double h = conductanceOf(pair, joined[c]);
        if (h > 0 && wall < 0)
        {
            network.join(pair.first, pair.second, h);
        }
        else if (h > 0 && walls[wall].temperature)
        {
            network.joinReservoir(pair.first, wall, h, *walls[wall].temperature);
        }
    }
    return network;
}

template class Conduction<2>;
template class Conduction<3>;

}  // namespace nscd
