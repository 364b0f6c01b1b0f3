// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/contact/Arrangement.hpp"
#include "nscd/impact/Flyer.hpp"
#include "nscd/impact/ImpactLaw.hpp"
#include "nscd/impact/WetRestitution.hpp"
#include "nscd/problem/ContactProblem.hpp"

#include <limits>

namespace nscd
{

/// The impacts of one sub-step at contacts with restitution: each at its own time and place, on the velocities that the
/// impacts before it have left.  What stays in contact is not its business: an impact must be faster than forces make
/// bodies in a sub-step, and after some at one contact those that follow are left to the contact problem, which is
/// plastic (a pile that collapses has an infinite number of them).
///
/// Two discs or spheres meet at a root of |y + v t| = R_i + R_j.  Members of clusters and walls meet where the gap,
/// linear in time from the last impact on, vanishes along the normal of the beginning.  Their impulse has one point,
/// arms and W of the time at which they meet, so that it keeps the angular momentum (Lever).
///
/// A group of contacts is worked on alone, in the order of time.  When another group has let a body collide at a later
/// time already, an impact that comes late is executed with the place where the lines of flight have crossed.
/// Pairwise impacts in their order: Guendelman, Bridson and Fedkiw 2003, doi:10.1145/882262.882358; late ones:
/// Bannerman et al. 2014, doi:10.1007/s40571-014-0021-8; termination: Vouga et al. 2017, doi:10.1145/3072959.3073689.
template <int D>
class Impacts
{
public:
    Impacts(const Arrangement<D>& arrangement, const Candidates<D>& candidates,
            const std::vector<WallBody<D>>& wallBodies, const BodyData<D>& data)
        : arrangement_(arrangement), candidates_(candidates), wallBodies_(wallBodies), data_(data)
    {
    }

    /// From now on impacts are those in a fluid.
    void setLubrication(WetRestitution law) { wet_ = std::move(law); }

    /// Be without impacts: the list of candidates is another one, or nothing bounces.
    void clear();

    /// List the contacts that may have impacts in a sub-step of length dt [s]; bodies that stand for points of driven
    /// walls are added to the flyers.  Contacts that carried an impulse in the sub-step before have impacts above
    /// the velocity 'resolved' only [m/s].  Returns whether any contact has an impact, as far as this rank sees.
    /// No body's velocity may differ by more than 'fastest' from 'usual', its surface included [m/s].
    bool begin(std::vector<Flyer<D>>& flyers, const std::vector<Launch<D>>& launches,
               const std::vector<Impulse<D>>& impulses, double dt, double resolved, const Vector<D>& usual,
               double fastest);

    /// Execute a group's impacts until a time [s].
    void work(int group, std::vector<Flyer<D>>& flyers, double until);

    /// Impacts of this rank.
    std::size_t count() const { return count_; }

    /// Contacts whose further impacts were left to the contact problem, of this rank.
    std::size_t exhausted() const { return exhausted_; }

    /// Kinetic energy that the impacts of each block's groups gave to the bodies, at their own time [J]; zero for other
    /// ranks' blocks.
    const std::vector<double>& energy() const { return energy_; }

    /// What the impacts of each of this rank's pairs gave to the second body, in the order of pairs.
    const std::vector<PairImpulse<D>>& impulses() const { return given_; }

    /// Fill in impulses(), when all impacts are over.
    void collectImpulses();

private:
    /// Impacts at one contact in one sub-step; those that follow are plastic.
    static constexpr int mostImpacts = 8;

    /// Share of the velocity by forces below which a contact is not let bounce: twice half of each body's, so that a
    /// grain on the floor rests, and normal to the contact four times that of the bodies against each other
    /// (doc/theory, eq. 5.16).
    static constexpr double share = 0.5, normalShare = 4;

    /// What a prediction reads and writes, in one line of the cache.
    struct alignas(64) Item
    {
        double time;           ///< of the next impact [s]
        int i, j;
        int seen;              ///< impacts of both bodies when that was found
        unsigned version;
        Vector<D> separation;  ///< of two discs or spheres, at the beginning [m]
        double touching;       ///< R_i + R_j of two discs or spheres [m]; 0 for others
        double slow;           ///< approach that is not an impact [m/s]
    };

    struct Details
    {
        std::size_t pair;
        Vector<D> normal;      ///< at the beginning
        double gap;            ///< at the beginning [m]
        const ContactParameters* law = nullptr;
        int lever = -1;        ///< index into levers_
        int impacts = 0;
        double met = 0;        ///< when the lines of flight cross: before the impact if it comes late [s]
        Vector<D> given = Vector<D>::Zero();
        double pressed = 0;
        Tangent<D> rolled = zeroTangent<D>();
        double viscous = 0;    ///< approach of Stokes number 1; 0 for no fluid [m/s]
    };

    /// A contact of a cluster's member, or with a free wall: where its two ends, the centre of the first member and
    /// that of the second or a point of the wall, lie in their bodies.
    struct Lever
    {
        Vector<D> first, second;             ///< from the bodies' centres, in the bodies' frames [m]
        Vector<D> startFirst, startSecond;   ///< the same at the beginning, in space [m]
        double lengthFirst, lengthSecond;    ///< of the bodies' turning [m]
        double radius;                       ///< of the first member [m]
        double touching;                     ///< R_i + R_j, or R_i of a wall [m]
        bool isWall;
    };

    /// The two ends of a lever against each other [m, m/s].
    struct Course
    {
        Vector<D> separation, velocity;
    };

    /// A contact of a body and the body on its other side.
    struct Touch
    {
        int item, other;
    };

    struct Event
    {
        double time;
        std::size_t item;
        unsigned version;

        /// For a heap that has the earliest on top.
        bool operator<(const Event& other) const
        {
            return time > other.time || (time == other.time && item > other.item);
        }
    };

    void list(const Group& group, std::vector<Flyer<D>>& flyers, const std::vector<Launch<D>>& launches,
              const std::vector<Impulse<D>>& impulses);
    void addLever(const Item& item, Details& details, const Pair& pair, const Approach<D>& approach,
                  const std::vector<Flyer<D>>& flyers);
    void listTouching(std::size_t bodies);

    void predict(std::size_t item, const std::vector<Flyer<D>>& flyers);

    /// Return the time [s]; 'met' is set if there is one.
    double predictRound(const Item& item, const Flyer<D>& a, const Flyer<D>& b, double now, double& met) const;
    double predictFlat(const Item& item, const Flyer<D>& a, const Flyer<D>& b, double now, Details& details) const;
    void schedule(std::size_t item, const std::vector<Flyer<D>>& flyers, double until);

    /// False, and nothing done, if the two do not approach where they meet.
    bool collide(std::size_t item, std::vector<Flyer<D>>& flyers, double& energy);

    /// Return the kinetic energy that the bodies gain [J].
    double collidePlain(const Item& item, Details& details, Flyer<D>& a, Flyer<D>& b);
    double collideLevered(const Item& item, Details& details, const LeveredContact<D>& c, Flyer<D>& a, Flyer<D>& b);
    double collideRolling(const Item& item, Details& details, LeveredContact<D> c, Flyer<D>& a, Flyer<D>& b);

    /// Where the two meet; from the first to the second.
    Vector<D> normalOf(const Item& item, const Details& details, const Flyer<D>& a, const Flyer<D>& b) const;

    /// The contact of two discs or spheres, or one and a wall, where they meet.
    LeveredContact<D> roundContact(const Item& item, const Details& details, const Flyer<D>& a,
                                   const Flyer<D>& b) const;

    /// Of a lever's ends, on straight lines from where the bodies had their last impacts, at the beginning.
    Course courseOf(const Lever& lever, const Flyer<D>& a, const Flyer<D>& b) const;

    /// The contact at a lever where the two meet; they have been turned to that time.
    LeveredContact<D> leveredContact(const Item& item, const Details& details, const Flyer<D>& a,
                                     const Flyer<D>& b) const;

    /// Is it a cluster or free wall?
    bool turns(int body) const { return body < candidates_.fixedBody() && data_.inertia[body][0] > 0; }

    /// Turn what turns to the time of an impact [s].
    void turnTo(double time, int body, Flyer<D>& flyer) const;

    /// How a body turns at a flyer's orientation.
    Turning<D> turningAt(int body, const Flyer<D>& flyer) const;

    /// Speed at which two bodies meet with a Stokes number of 1 [m/s].
    double viscousSpeed(const Item& item, const Pair& pair, const std::vector<Flyer<D>>& flyers) const;

    /// Of bodies that approach each other with a velocity [m/s].
    double restitution(const Details& details, double approach) const;

    /// What the bodies' relative velocity is at a time [s] above that with which they fly, which is the one in the
    /// middle of the sub-step (doc/theory, eq. 5.14) [m/s].
    Vector<D> gainedBy(const Item& item, double time) const;

    /// What an impulse and a moment do to a body that is driven, which does not count [J].
    static double workOnDriven(const Flyer<D>& b, const Vector<D>& impulse,
                               const Tangent<D>& moment = zeroTangent<D>());

    /// Let a body go on with its new velocity from where it had the impact.
    void divert(int body, std::vector<Flyer<D>>& flyers, const Body<D>& before, double met, double time) const;

    static constexpr double never = std::numeric_limits<double>::infinity();

    const Arrangement<D>& arrangement_;
    const Candidates<D>& candidates_;
    const std::vector<WallBody<D>>& wallBodies_;
    const BodyData<D>& data_;
    WetRestitution wet_;   ///< empty for no fluid
    const std::vector<Launch<D>>* launches_ = nullptr;
    double dt_ = 0, resolved_ = 0, fastest_ = 0;
    Vector<D> usual_ = Vector<D>::Zero();
    std::vector<Item> items_;
    std::vector<Details> details_;              ///< of each item
    std::vector<Lever> levers_;
    std::vector<std::size_t> begin_;            ///< first item of each group, and the end
    std::vector<Touch> touching_;               ///< items of each body
    std::vector<int> touchingBegin_;
    std::vector<Event> heap_;
    std::vector<double> energy_;
    std::vector<PairImpulse<D>> given_;
    std::size_t count_ = 0, exhausted_ = 0;
};

}  // namespace nscd
