// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Peer.hpp"

#ifdef HAVE_PEER

#include <overlap/overlap.hpp>

namespace
{

template <class Element>
class PeerCell : public Peer
{
public:
    explicit PeerCell(const Element& element) : element_(element) {}

    double volume(const Eigen::Vector3d& centre, double radius) const override
    {
        return overlap::overlap_volume(overlap::Sphere(centre, radius), element_);
    }

private:
    Element element_;
};

}  // namespace

std::unique_ptr<Peer> makePeer(const std::vector<Eigen::Vector3d>& v)
{
    using overlap::Hexahedron, overlap::Tetrahedron;
    if (v.size() == 4) return std::make_unique<PeerCell<Tetrahedron>>(Tetrahedron(v[0], v[1], v[2], v[3]));
    return std::make_unique<PeerCell<Hexahedron>>(Hexahedron(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7]));
}

#else

std::unique_ptr<Peer> makePeer(const std::vector<Eigen::Vector3d>&)
{
    return nullptr;
}

#endif
