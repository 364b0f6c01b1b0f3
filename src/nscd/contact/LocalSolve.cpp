// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/contact/LocalSolve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace nscd
{

namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Newton's method squares the relative error of the last step.
constexpr double newtonEnds = 1e-8;

/// Bisection alone needs some 60.
constexpr int mostIterations = 200;

/// The contact without its normal direction: A r_T = u_T - slip, r_N = push - lever.r_T.
template <int D>
struct Reduced
{
    using Tangential = Eigen::Matrix<double, D - 1, 1>;
    using Square = Eigen::Matrix<double, D - 1, D - 1>;

    Reduced(const Block<D>& W, const Vector<D>& q, double friction)
        : lever(W.template block<1, D - 1>(0, 1).transpose() / W(0, 0)), mu(friction), push(-q[0] / W(0, 0)),
          slip(q.template tail<D - 1>() + W.template block<D - 1, 1>(1, 0) * push),
          A(W.template block<D - 1, D - 1>(1, 1) - W.template block<D - 1, 1>(1, 0) * lever.transpose()),
          rounding(8 * epsilon
                   * (W.template block<D - 1, D - 1>(1, 1).norm()
                      + W.template block<D - 1, 1>(1, 0).norm() * lever.norm() + epsilon * W(0, 0)))
    {
    }

    double normal(const Tangential& tangential) const { return push - lever.dot(tangential); }

    /// |r_T| - mu r_N: not positive within the cone.
    double excess(const Tangential& tangential) const { return tangential.norm() - mu * normal(tangential); }

    Vector<D> impulse(const Tangential& tangential) const
    {
        Vector<D> r;
        r << normal(tangential), tangential;
        return r;
    }

    Vector<D> withoutFriction() const { return impulse(Tangential::Zero()); }

    /// On the surface of the cone, r_T along the given unit vector.
    Vector<D> sliding(const Tangential& along) const
    {
        const double denominator = 1 + mu * lever.dot(along);
        if (denominator <= 0)
        {
            return withoutFriction();
        }
        const double r = push / denominator;
        return impulse(mu * r * along);
    }

    Tangential lever;
    double mu, push;
    Tangential slip;
    Square A;
    double rounding;  ///< eigenvalues of A below this are taken for zero [1/kg]
};

Vector<2> solve(const Reduced<2>& c, const Vector<2>&)
{
    using Tangential = Reduced<2>::Tangential;
    if (c.A(0, 0) > c.rounding)
    {
        const Tangential stick = -c.slip / c.A(0, 0);
        if (c.excess(stick) <= 0)
        {
            return c.impulse(stick);
        }
    }
    return c.sliding(Tangential::Constant(c.slip[0] > 0 ? -1 : 1));
}

/// A positive definite matrix of two rows, x.Mx > 0, after elimination; it needs no pivot.
class Eliminated
{
public:
    explicit Eliminated(const Block<2>& M)
        : above_(M(0, 1)), inverse_(1 / M(0, 0)), factor_(M(1, 0) * inverse_), other_(1 / (M(1, 1) - factor_ * above_))
    {
    }

    Vector<2> solve(const Vector<2>& b) const
    {
        const double y = (b[1] - factor_ * b[0]) * other_;
        return {(b[0] - above_ * y) * inverse_, y};
    }

private:
    double above_, inverse_, factor_, other_;
};

/// The tangential impulses from none, t = 0, to the sticking one, t = 1,
///     [t A + (1 - t) a 1] r_T = -t slip,   that is u_T = -s r_T with s = a (1 - t)/t.
/// Where A = a 1, r_T is linear in t.
class Line
{
public:
    explicit Line(const Reduced<3>& contact) : c_(contact), mean_(0.5 * c_.A.trace())
    {
        const double difference = 0.5 * (c_.A(0, 0) - c_.A(1, 1)), mixed = 0.5 * (c_.A(0, 1) + c_.A(1, 0));
        const double spread = std::sqrt(difference * difference + mixed * mixed);
        smallest_ = mean_ - spread;
        a_ = mean_ > c_.rounding ? mean_ : std::abs(mean_) + spread + c_.rounding;
    }

    /// Is there a sticking impulse?
    bool regular() const { return smallest_ > c_.rounding; }

    /// How far the matrix is positive definite, t included.
    double end() const { return regular() ? 1 : (1 - 1e-13) * a_ / (a_ - std::min(smallest_, 0.0)); }

    Vector<2> impulse(double t) const { return Eliminated(matrix(t)).solve(-t * c_.slip); }

    /// s |r_T|
    double slipSpeed(double t, const Vector<2>& impulse) const { return a_ * (1 - t) / t * impulse.norm(); }

    /// Where on the line an impulse of about this slip would lie.
    double near(const Vector<2>& impulse) const
    {
        const double square = a_ * impulse.squaredNorm();
        const double slipPower = impulse.dot(c_.slip + c_.A * impulse);
        return slipPower < 0 ? square / (square - slipPower) : 1;
    }

    /// The impulse and its derivative.
    std::pair<Vector<2>, Vector<2>> impulseAndSlope(double t) const
    {
        const Eliminated M(matrix(t));
        const Vector<2> impulse = M.solve(-t * c_.slip);
        return {impulse, M.solve(a_ * impulse - c_.A * impulse - c_.slip)};
    }

private:
    Block<2> matrix(double t) const { return t * c_.A + (1 - t) * a_ * Block<2>::Identity(); }

    const Reduced<3>& c_;
    double mean_, smallest_, a_;
};

/// The impulse on the line where the excess vanishes; it is negative at t = 0 and positive at 'upper'.
Vector<2> slidingImpulse(const Reduced<3>& c, const Line& line, double upper, double upperExcess,
                         const Vector<2>& guess)
{
    double lower = 0;
    double before = upperExcess;
    double t = line.near(guess);
    if (t <= 0 || t >= upper)
    {
        t = upper * c.mu * c.push / (c.mu * c.push + upperExcess);
    }
    for (int iteration = 0;; ++iteration)
    {
        const auto [impulse, change] = line.impulseAndSlope(t);
        const double length = impulse.norm();
        const double excess = length - c.mu * c.normal(impulse);
        const double slope = length > 0 ? impulse.dot(change) / length + c.mu * c.lever.dot(change) : 0;
        if (slope > 0 && std::abs(excess) <= newtonEnds * length)
        {
            return impulse - excess / slope * change;
        }
        (excess < 0 ? lower : upper) = t;
        const bool converges = slope > 0 && std::abs(excess) < 0.5 * std::abs(before);
        const double newton = converges ? t - excess / slope : upper;
        const double next = newton > lower && newton < upper ? newton : 0.5 * (lower + upper);
        if (next <= lower || next >= upper || iteration == mostIterations)
        {
            return impulse;
        }
        t = next;
        before = excess;
    }
}

Vector<3> solve(const Reduced<3>& c, const Vector<3>& guess)
{
    const Line line(c);
    const double end = line.end();
    const Vector<2> stick = line.impulse(end);
    const double excess = c.excess(stick);
    if (excess <= 0)
    {
        // Where A is singular the end of the line sticks only if its slip is within the range of A
        const bool sticks = line.regular() || line.slipSpeed(end, stick) <= 1e-12 * c.slip.norm();
        return sticks ? c.impulse(stick) : c.withoutFriction();
    }
    const Vector<2> impulse = slidingImpulse(c, line, end, excess, guess.tail<2>());
    const double length = impulse.norm();
    return length > 0 ? c.sliding(impulse / length) : c.withoutFriction();
}

}  // namespace

template <int D>
Vector<D> solveLocal(const Block<D>& W, const Vector<D>& q, double mu, const Vector<D>& guess)
{
    if (q[0] >= 0)
    {
        return Vector<D>::Zero();
    }
    const Reduced<D> contact(W, q, mu);
    return mu > 0 && contact.slip.norm() > 0 ? solve(contact, guess) : contact.withoutFriction();
}

template Vector<2> solveLocal<2>(const Block<2>&, const Vector<2>&, double, const Vector<2>&);
template Vector<3> solveLocal<3>(const Block<3>&, const Vector<3>&, double, const Vector<3>&);

}  // namespace nscd
