// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Pairs of ball and cell that cut each other: time per pair, beside the package overlap if the build has found it.

#include "bestOf.hpp"
#include "Cells.hpp"
#include "overlap/ball/BallPolyhedron.hpp"
#include "Peer.hpp"

#include <cmath>
#include <cstdio>
#include <memory>
#include <random>

using namespace overlap;

namespace
{

constexpr std::size_t nPairs = 1000;

struct Pair
{
    Point3 centre;
    std::unique_ptr<Polyhedron> cell;
    std::unique_ptr<Peer> peer;
};

/// Cells of size h about the origin that the surface of a ball of diameter 1 passes through.
std::vector<Pair> cutPairs(const CellKind& kind, double h)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double reach = 0.5 + h * kind.reach, whole = pi / 6;

    std::vector<Pair> pairs;
    while (pairs.size() < nPairs)
    {
        std::vector<Point3> vertices = kind.vertices(random);
        for (Point3& v : vertices) v *= h;
        auto cell = std::make_unique<Polyhedron>(vertices, kind.faces);
        for (int attempt = 0; attempt < 10; ++attempt)
        {
            const Point3 centre = reach * Point3(unit(random), unit(random), unit(random));
            const double volume = ballPolyhedron(centre, 0.5, *cell).volume;
            const double limit = std::min(whole, cell->volume()) * (1 - 1e-9);
            if (volume < 1e-9 * limit || volume > limit) continue;
            pairs.push_back({centre, std::move(cell), makePeer(vertices)});
            break;
        }
    }
    return pairs;
}

/// Nanoseconds per call of f(pair).
template <class F>
double time(const std::vector<Pair>& pairs, F&& f)
{
    volatile double sink = 0;
    const double seconds = bestOf(12,
                                  [&]
                                  {
                                      double sum = 0;
                                      for (const Pair& pair : pairs) sum += f(pair);
                                      sink = sum;
                                  });
    static_cast<void>(sink);
    return 1e9 * seconds / static_cast<double>(pairs.size());
}

}  // namespace

int main()
{
    const std::vector<CellKind> kinds = cellKinds();
    std::printf("ns per cut pair: volume of the package overlap / volume, centroid and wetted area of grainFoam\n%8s",
                "h/d");
    for (const CellKind& kind : kinds) std::printf("  %22s", kind.name);
    std::printf("  %s\n", "largest difference of volumes / smaller volume");

    for (const double h : {1. / 30, 0.1, 1. / 3, 1., 3., 10., 30.})
    {
        std::printf("%8.4f", h);
        double difference = 0;
        for (const CellKind& kind : kinds)
        {
            const std::vector<Pair> pairs = cutPairs(kind, h);
            const auto ours = [](const Pair& pair)
            {
                const BallOverlap x = ballPolyhedron(pair.centre, 0.5, *pair.cell);
                return x.volume + x.centroid.x() + x.wettedArea;
            };
            const double own = time(pairs, ours);
            if (!pairs[0].peer)
            {
                std::printf("  %22.0f", own);
                continue;
            }
            const auto peers = [](const Pair& pair) { return pair.peer->volume(pair.centre, 0.5); };
            std::printf("  %12.0f / %7.0f", time(pairs, peers), own);
            for (const Pair& pair : pairs)
            {
                const double smaller = std::min(pi / 6, pair.cell->volume());
                const double volume = ballPolyhedron(pair.centre, 0.5, *pair.cell).volume;
                difference = std::max(difference, std::abs(volume - peers(pair)) / smaller);
            }
        }
        std::printf("  %.1e\n", difference);
    }
}
