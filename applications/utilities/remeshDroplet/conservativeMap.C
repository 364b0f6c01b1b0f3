/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "conservativeMap.H"

#include "overlap/clip/Clip.hpp"
#include "overlap/disc/DiscPolygon.hpp"

#include <Eigen/IterativeLinearSolvers>

namespace
{

using namespace Foam;
typedef planarMesh::point2 point2;

}


Foam::conservativeMap::conservativeMap
(
    const planarMesh& old,
    const scalarField& oldShare,
    const planarMesh& fresh,
    const scalarField& freshShare,
    const openArea& open
)
:
    old_(old),
    isOpen_(oldShare.size()),
    isFilled_(freshShare.size()),
    gain_(0),
    defect_(0)
{
    forAll(oldShare, i)
    {
        isOpen_[i] = oldShare[i] > least;
    }
    forAll(freshShare, i)
    {
        isFilled_[i] = freshShare[i] > least;
    }
    setPieces(fresh, open);

    // Shares in cells that the droplet cuts, and grains, are not exact
    constexpr scalar unknown = 1e-6;
    const scalarField filled(freshShare*fresh.mesh().V().field());
    scalarField given(oldShare*old.mesh().V().field());
    gain_ = sum(filled)/sum(given) - 1;
    given *= 1 + gain_;
    scalarField from(given.size(), Zero), to(filled.size(), Zero);
    for (piece& p : pieces_)
    {
        p.volume += unknown*p.area*old.depth()*oldShare[p.from]*freshShare[p.to];
        from[p.from] += p.volume;
        to[p.to] += p.volume;
    }
    for (piece& p : pieces_)
    {
        p.volume =
            isOpen_[p.from] && isFilled_[p.to]
          ? p.volume*given[p.from]/from[p.from]*filled[p.to]/to[p.to]
          : 0;
    }
    balance(given, filled);
    setMiddles();
}


void Foam::conservativeMap::setPieces
(
    const planarMesh& fresh,
    const openArea& open
)
{
    for (label to = 0; to < fresh.nCells(); ++to)
    {
        const point2* corners = fresh.polygon(to);
        const label n = fresh.polygonSize(to);
        old_.forCells
        (
            fresh.box(to),
            [&](const label from)
            {
                std::vector<point2> part
                (
                    old_.polygon(from),
                    old_.polygon(from) + old_.polygonSize(from)
                );
                for (label i = 0; i < n && part.size(); ++i)
                {
                    const point2 side(corners[(i + 1) % n] - corners[i]);
                    const point2 outwards(side[1], -side[0]);
                    part = overlap::clipped
                    (
                        part,
                        {outwards.normalized(), corners[i]}
                    );
                }
                if (part.size() < 3)
                {
                    return;
                }
                const overlap::AreaMoment moment
                (
                    overlap::polygon(part.data(), part.size())
                );
                if (moment.area <= 0)
                {
                    return;
                }
                pieces_.push_back
                (
                    {
                        from, to, moment.area, moment.centroid,
                        open(from, part)*old_.depth()
                    }
                );
            }
        );
    }
}


void Foam::conservativeMap::balance
(
    const scalarField& given,
    const scalarField& filled
)
{
    typedef Eigen::SparseMatrix<double> matrix;
    typedef Eigen::VectorXd column;
    const Eigen::Map<const column> a(given.cdata(), given.size());
    const Eigen::Map<const column> b(filled.cdata(), filled.size());
    const auto volumes = [&]()
    {
        std::vector<Eigen::Triplet<double>> entries;
        for (const piece& p : pieces_)
        {
            if (p.volume > 0)
            {
                entries.emplace_back(p.from, p.to, p.volume);
            }
        }
        matrix result(a.size(), b.size());
        result.setFromTriplets(entries.begin(), entries.end());
        return result;
    };
    const auto scale = [&](const column& x, const column& y)
    {
        for (piece& p : pieces_)
        {
            p.volume *= x[p.from]*y[p.to];
        }
    };
    const auto over = [](const column& x, const column& y)
    {
        return column((y.array() > 0).select(x.array()/y.array(), 0));
    };

    // Newton's method for the factors exp(x_i + y_j) of the pieces.  Damped, as parts
    // of the fluid that do not hang together may differ in what they are to give
    constexpr label mostSteps = 15;
    constexpr scalar damping = 1e-5;
    for (label i = 0; i < mostSteps; ++i)
    {
        // Each new cell is filled exactly
        const matrix before(volumes());
        scale
        (
            column::Ones(a.size()),
            over(b, before.transpose()*column::Ones(a.size()))
        );
        const matrix F(volumes());
        const column gives(F*column::Ones(b.size()));
        const column lack((gives.array() > 0).select(a - gives, 0));
        defect_ = lack.cwiseAbs().maxCoeff()/a.sum();
        if (defect_ < 1e-16)
        {
            break;
        }
        const column perFilled(over(column::Ones(b.size()), b));
        matrix S(-(F*perFilled.asDiagonal()*F.transpose()));
        for (label k = 0; k < given.size(); ++k)
        {
            S.coeffRef(k, k) += (1 + damping)*gives[k] + (gives[k] > 0 ? 0 : 1);
        }
        Eigen::ConjugateGradient<matrix, Eigen::Lower | Eigen::Upper> solver;
        solver.setTolerance(1e-6);
        const column x
        (
            solver.compute(S).solve(lack).cwiseMax(-1).cwiseMin(1)
        );
        scale
        (
            x.array().exp(),
            (-(F.transpose()*x).cwiseProduct(perFilled)).array().exp()
        );
    }
}


void Foam::conservativeMap::setMiddles()
{
    middles_.assign(isOpen_.size(), point2(0, 0));
    scalarField given(isOpen_.size(), Zero);
    for (const piece& p : pieces_)
    {
        given[p.from] += p.volume;
        middles_[p.from] += p.volume*p.centre;
    }
    forAll(given, i)
    {
        middles_[i] /= max(given[i], VSMALL);
    }
}


Foam::scalarField Foam::conservativeMap::map
(
    const scalarField& x,
    const List<scalarField>& onPatches,
    const label nCells
) const
{
    std::vector<point2> slope;
    slopes(x, onPatches, slope);

    scalarField filled(nCells, Zero), area(nCells, Zero);
    for (const piece& p : pieces_)
    {
        filled[p.to] += p.volume;
        area[p.to] += p.area;
    }
    scalarField result(nCells, Zero);
    for (const piece& p : pieces_)
    {
        if (filled[p.to] <= 0)
        {
            // In a body: what is there
            result[p.to] += p.area/area[p.to]*x[p.from];
        }
        else if (p.volume > 0)
        {
            result[p.to] +=
                p.volume/filled[p.to]
               *(
                    x[p.from]
                  + slope[p.from].dot(p.centre - middles_[p.from])
                );
        }
    }
    return result;
}
