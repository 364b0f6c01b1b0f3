// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/heat/Conduction.hpp"

#include "nscd/base/Check.hpp"

#include <cmath>
#include <limits>
#include <string>

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
double Conduction<D>::conductance(const ContactForce<D>& contact, const Grains<D>& grains,
                                  const std::vector<ThermalWall>& walls) const
{
    const bool isWall = contact.second < 0;
    const int other = isWall ? walls[~contact.second].material : grains.material[contact.second];
    return law_({materials_[grains.material[contact.first]], materials_[other],
                 radiusAt<D>(grains, contact.first, contact.point),
                 isWall ? std::numeric_limits<double>::infinity() : radiusAt<D>(grains, contact.second, contact.point),
                 contact.pressing, length_});
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

    HeatNetwork network(heatCapacity);
    for (std::size_t c = 0; c < contacts.size(); ++c)
    {
        const ContactForce<D>& contact = contacts[c];
        checkIndex(contact.first, grains.size(), "contact", c, "grain");
        const int wall = ~contact.second;
        if (wall < 0)
        {
            checkIndex(contact.second, grains.size(), "contact", c, "grain");
        }
        else
        {
            checkIndex(wall, walls.size(), "contact", c, "wall");
        }
        const double h = conductance(contact, grains, walls);
        if (h > 0 && wall < 0)
        {
            network.join(contact.first, contact.second, h);
        }
        else if (h > 0 && walls[wall].temperature)
        {
            network.joinReservoir(contact.first, wall, h, *walls[wall].temperature);
        }
    }
    return network;
}

template class Conduction<2>;
template class Conduction<3>;

}  // namespace nscd
