// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Time per disc/cell pair whose bounding boxes overlap, for cells much smaller to much larger than the disc.
// Prints a row per h/d: all candidate pairs, and those in which the circle passes through the cell.

#include "bestOf.hpp"
#include "overlap/disc/DiscPolygon.hpp"

#include <cstdio>
#include <random>
#include <vector>

using overlap::Point2;

namespace
{

struct Pair
{
    Point2 centre;
    Point2 vertices[4];
};

constexpr std::size_t nPairs = 4096;
constexpr double pi = 3.14159265358979323846;

/// Slightly distorted cells of size h with n = 3 or 4 vertices near a disc of unit diameter.
std::vector<Pair> makePairs(double h, std::size_t n, bool onlyCut)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double reach = 0.5 + 0.5 * h;
    const Point2 corners[] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};

    std::vector<Pair> pairs;
    while (pairs.size() < nPairs)
    {
        Pair pair;
        pair.centre = Point2(reach * unit(random), reach * unit(random));
        for (std::size_t k = 0; k < n; ++k)
        {
            pair.vertices[k] = h * (corners[k] + 0.1 * Point2(unit(random), unit(random)));
        }

        const double area = overlap::discPolygon(pair.centre, 0.5, pair.vertices, n).area;
        const double cell = overlap::polygon(pair.vertices, n).area;
        const bool cut = area > 0 && area < pi / 4 * (1 - 1e-12) && area < cell * (1 - 1e-12);
        if (cut || !onlyCut) pairs.push_back(pair);
    }
    return pairs;
}

/// Nanoseconds per pair.
double measure(const std::vector<Pair>& pairs, std::size_t n)
{
    constexpr int repeats = 5;
    volatile double sink = 0;
    const double seconds =
        bestOf(15,
               [&]
               {
                   double sum = 0;
                   for (int repeat = 0; repeat < repeats; ++repeat)
                   {
                       for (const Pair& pair : pairs)
                       {
                           const overlap::AreaMoment a = overlap::discPolygon(pair.centre, 0.5, pair.vertices, n);
                           sum += a.area + a.centroid.x();
                       }
                   }
                   sink = sum;
               });
    static_cast<void>(sink);
    return 1e9 * seconds / (repeats * static_cast<double>(pairs.size()));
}

}  // namespace

int main()
{
    std::printf("%8s  %26s  %26s\n", "", "all candidates [ns]", "cut pairs [ns]");
    std::printf("%8s  %12s  %12s  %12s  %12s\n", "h/d", "quad", "triangle", "quad", "triangle");
    for (const double h : {1. / 30, 0.1, 1. / 3, 1., 3., 10., 30.})
    {
        std::printf("%8.4f", h);
        for (const bool onlyCut : {false, true})
        {
            for (const std::size_t n : {std::size_t(4), std::size_t(3)})
            {
                std::printf("  %12.1f", measure(makePairs(h, n, onlyCut), n));
            }
        }
        std::printf("\n");
    }
}
