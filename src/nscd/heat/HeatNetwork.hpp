// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <utility>
#include <vector>

namespace nscd
{

/// Bodies of given heat capacity, joined to each other and to reservoirs of fixed temperature by conductances > 0.
class HeatNetwork
{
public:
    explicit HeatNetwork(std::vector<double> capacity) : capacity_(std::move(capacity)) {}

    /// Join bodies i and j [W/K].
    void join(int i, int j, double conductance) { links_.push_back({i, j, conductance}); }

    /// Join body i to a reservoir [W/K, K].
    void joinReservoir(int i, int reservoir, double conductance, double temperature)
    {
        outlets_.push_back({i, reservoir, conductance, temperature});
    }

    /// One step of dt [s] by the implicit Euler method (doc/theory, eq. 6.8); adds to 'given' what each reservoir
    /// gave [J].
    void advance(std::vector<double>& temperature, std::vector<double>& given, double dt) const;

    struct Link
    {
        int i, j;
        double conductance;  ///< [W/K]
    };

    struct Outlet
    {
        int i, reservoir;
        double conductance, temperature;  ///< [W/K, K]
    };

    const std::vector<Link>& links() const { return links_; }
    const std::vector<Outlet>& outlets() const { return outlets_; }

private:
    std::vector<double> change(const std::vector<double>& temperature, double dt) const;
    std::vector<int> components() const;

    std::vector<double> capacity_;
    std::vector<Link> links_;
    std::vector<Outlet> outlets_;
};

}  // namespace nscd
