// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/problem/SparseSolve.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <limits>

namespace nscd
{

namespace
{

/// Changes of this many times the largest velocity in the beginning have lost all meaning.
constexpr double unbounded = 1e12;

/// Momentum starts anew when a sweep changes more than this times the least change since the last start.
constexpr double astray = 1.02;

/// Sweeps with momentum that may pass without a new least change; doubled every time.
constexpr int firstPatience = 100;

/// What one sweep changed, in units of velocity: W_NN times the change of the impulse [m/s].
struct SweepChange
{
    double largest = 0;
    double total = 0;  ///< root of the sum of squares
};

/// The contacts that wait for their solution, one bit each, taken in the order of their numbers round and round:
/// as many solutions as first in, first out, and neighbours in memory stay together.
class Waiting
{
public:
    explicit Waiting(int contacts) : words_(contacts / 64 + 1, 0) {}

    bool any() const { return count_ > 0; }

    void add(int contact)
    {
        const std::uint64_t bit = std::uint64_t(1) << contact % 64;
        count_ += (words_[contact / 64] & bit) == 0;
        words_[contact / 64] |= bit;
    }

    int take()
    {
        std::uint64_t word = words_[place_] & ahead_;
        while (word == 0)
        {
            place_ = (place_ + 1) % words_.size();
            word = words_[place_];
        }
        const int bit = __builtin_ctzll(word);
        words_[place_] &= ~(std::uint64_t(1) << bit);
        ahead_ = ~std::uint64_t(0) << bit;
        --count_;
        return static_cast<int>(64 * place_) + bit;
    }

private:
    std::vector<std::uint64_t> words_;
    std::uint64_t ahead_ = ~std::uint64_t(0);  ///< of the present word, what has not been passed yet
    std::size_t place_ = 0, count_ = 0;
};

/// The blocks of W by columns: what an impulse does to the velocities of all contacts.
template <int D>
class Columns
{
public:
    using Neighbour = typename SparseProblem<D>::Neighbour;

    explicit Columns(const SparseProblem<D>& p) : first_(p.contacts() + 1, 0), blocks_(p.blocks())
    {
        for (int c = 0; c < p.contacts(); ++c)
        {
            std::for_each(p.begin(c), p.end(c), [&](const Neighbour& n) { ++first_[n.contact + 1]; });
        }
        for (std::size_t c = 1; c < first_.size(); ++c)
        {
            first_[c] += first_[c - 1];
        }
        std::vector<std::size_t> next = first_;
        for (int c = 0; c < p.contacts(); ++c)
        {
            std::for_each(p.begin(c), p.end(c), [&](const Neighbour& n) { blocks_[next[n.contact]++] = {c, n.W}; });
        }
    }

    const Neighbour* begin(int contact) const { return blocks_.data() + first_[contact]; }
    const Neighbour* end(int contact) const { return blocks_.data() + first_[contact + 1]; }

private:
    std::vector<std::size_t> first_;
    std::vector<Neighbour> blocks_;
};

template <int D>
class Iteration
{
public:
    Iteration(const SparseProblem<D>& problem, const SolveLimits& limits, SparseSolution<D>& solution)
        : p_(problem), limits_(limits), s_(solution), r_(solution.r), contacts_(problem.contacts()),
          checkBelow_(limits.tolerance)
    {
        for (int c = 0; c < contacts_; ++c)
        {
            bound_ = std::max({bound_, unbounded * p_.q()[c].norm(), unbounded * p_.own(c)(0, 0) * r_[c].norm()});
        }
    }

    void run(Solver solver)
    {
        check();
        if (done_)
        {
            return;
        }
        switch (solver)
        {
        case Solver::sweeps:
            sweeps(limits_.maxSweeps);
            break;
        case Solver::queue:
            queue();
            break;
        case Solver::nesterov:
            for (int patience = firstPatience; !done_; patience = std::min(2 * patience, limits_.maxSweeps))
            {
                accelerated(patience);
                sweeps(patience);
            }
        }
    }

private:
    void check()
    {
        s_.residual = residual(p_, r_);
        s_.converged = s_.residual.worst <= limits_.tolerance;
        done_ = s_.converged || s_.sweeps >= limits_.maxSweeps;
    }

    /// Replace a contact's impulse by the solution for the velocity u; returns the change.
    Vector<D> improve(int c, const Vector<D>& u)
    {
        const Vector<D> before = r_[c];
        r_[c] = solveLocal<D>(p_.own(c), u - p_.own(c) * before, p_.friction()[c], before);
        return r_[c] - before;
    }

    /// Gauss-Seidel; decides whether the solver is done.
    SweepChange sweep()
    {
        double largest = 0, sum = 0;
        for (int c = 0; c < contacts_; ++c)
        {
            const double square = (p_.own(c)(0, 0) * improve(c, p_.velocity(c, r_))).squaredNorm();
            largest = std::max(largest, square);
            sum += square;
        }
        s_.sweeps += 1;
        const SweepChange change{std::sqrt(largest), std::sqrt(sum)};
        const bool lost = !(change.total <= bound_);
        if (change.largest <= checkBelow_ || s_.sweeps >= limits_.maxSweeps || lost)
        {
            check();
            done_ = done_ || lost || change.largest == 0;
            if (!done_)
            {
                checkBelow_ = change.largest * std::max(0.1, 0.9 * limits_.tolerance / s_.residual.worst);
            }
        }
        return change;
    }

    void sweeps(int count)
    {
        while (!done_ && count-- > 0)
        {
            sweep();
        }
    }

    /// Sweeps with momentum until 'patience' of them have passed without a new least change.
    void accelerated(int patience)
    {
        Vectors<D> last = r_;
        double theta = 1;
        double least = std::numeric_limits<double>::infinity();  // since the momentum's start
        double leastEver = least;
        for (int since = 0; since < patience; ++since)
        {
            const double change = sweep().total;
            if (done_)
            {
                return;
            }
            if (change < leastEver)
            {
                leastEver = change;
                since = 0;
            }
            least = std::min(least, change);
            const double next = 0.5 * (1 + std::sqrt(1 + 4 * theta * theta));
            double momentum = (theta - 1) / next;
            theta = next;
            if (change > astray * least)
            {
                theta = 1;
                momentum = 0;
                least = std::numeric_limits<double>::infinity();
            }
            for (int c = 0; c < contacts_; ++c)
            {
                const Vector<D> x = r_[c];
                r_[c] += momentum * (x - last[c]);
                last[c] = x;
            }
        }
        r_ = last;
    }

    /// A contact in the eyes of the queue.
    struct Watched
    {
        Vector<D> velocity;
        Vector<D> drift;  ///< change of the velocity since the contact was solved
        double limit;     ///< square of a drift that changes the natural map by the tolerance [m^2/s^2]
    };

    void queue()
    {
        const Columns<D> columns(p_);
        Waiting waiting(contacts_);
        std::vector<Watched> watched(contacts_);
        double solves = 0;
        for (int round = 0; round < limits_.maxSweeps && !done_; ++round)
        {
            for (int c = 0; c < contacts_; ++c)
            {
                const double limit = limits_.tolerance / (1 + p_.friction()[c]);
                watched[c] = {p_.velocity(c, r_), Vector<D>::Zero(), limit * limit};
                const Vector<D> e = naturalMap<D>(p_.own(c)(0, 0), p_.friction()[c], r_[c], watched[c].velocity);
                if (e.squaredNorm() > watched[c].limit)
                {
                    waiting.add(c);
                }
            }
            double largest = 0;
            for (; waiting.any() && solves < double(limits_.maxSweeps) * contacts_ && largest <= bound_; ++solves)
            {
                const int c = waiting.take();
                const Vector<D> change = improve(c, watched[c].velocity);
                largest = std::max(largest, p_.own(c)(0, 0) * change.norm());
                for (const auto* n = columns.begin(c); n != columns.end(c); ++n)
                {
                    Watched& other = watched[n->contact];
                    const Vector<D> step = n->W * change;
                    other.velocity += step;
                    other.drift += step;
                    if (other.drift.squaredNorm() > other.limit && n->contact != c)
                    {
                        waiting.add(n->contact);
                    }
                }
                watched[c].drift.setZero();
            }
            s_.sweeps = solves / contacts_;
            check();
            done_ = done_ || largest == 0 || !(largest <= bound_);
        }
    }

    const SparseProblem<D>& p_;
    const SolveLimits& limits_;
    SparseSolution<D>& s_;
    Vectors<D>& r_;
    const int contacts_;
    double checkBelow_;  ///< change of a sweep below which it is worth to compute the residual [m/s]
    double bound_ = 0;   ///< [m/s]
    bool done_ = false;
};

template <int D>
void checkInput(const SparseProblem<D>& problem, const SolveLimits& limits, const Vectors<D>& guess)
{
    if (!isPositive(limits.tolerance))
    {
        refuse("tolerance ", limits.tolerance, " m/s is not positive");
    }
    if (limits.maxSweeps < 0)
    {
        refuse("maxSweeps ", limits.maxSweeps, " is negative");
    }
    if (!guess.empty() && guess.size() != problem.q().size())
    {
        refuse("a guess of ", guess.size(), " impulses for ", problem.contacts(), " contacts");
    }
    for (std::size_t c = 0; c < guess.size(); ++c)
    {
        if (!isFinite(guess[c]))
        {
            refuse("contact ", c, ": the guess is not finite");
        }
    }
}

}  // namespace

template <int D>
SparseSolution<D> solve(const SparseProblem<D>& problem, Solver solver, const SolveLimits& limits, Vectors<D> guess)
{
    const std::clock_t start = std::clock();
    checkInput(problem, limits, guess);
    guess.resize(problem.contacts(), Vector<D>::Zero());
    SparseSolution<D> solution;
    solution.r = std::move(guess);
    Iteration<D>(problem, limits, solution).run(solver);
    solution.cpuSeconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    return solution;
}

template SparseSolution<2> solve<2>(const SparseProblem<2>&, Solver, const SolveLimits&, Vectors<2>);
template SparseSolution<3> solve<3>(const SparseProblem<3>&, Solver, const SolveLimits&, Vectors<3>);

}  // namespace nscd
