// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "overlap/base/Types.hpp"

#include <cmath>

namespace overlap
{

/// Sum of signed angles, each in (-pi, pi): one complex product and the number of times its argument passed pi.
class AngleSum
{
public:
    /// Add the angle whose cosine and sine are in the ratio cosine : sine.
    void add(double cosine, double sine)
    {
        const double re = re_ * cosine - im_ * sine;
        const double im = re_ * sine + im_ * cosine;
        if (im_ >= 0 && sine > 0 && im < 0) ++turns_;
        if (im_ < 0 && sine < 0 && im >= 0) --turns_;
        re_ = re;
        im_ = im;

        const double size = std::abs(re_) + std::abs(im_);
        if (size > 1e100 || size < 1e-100)
        {
            const double scale = size > 1 ? 1e-100 : 1e100;
            re_ *= scale;
            im_ *= scale;
        }
    }

    double value() const { return std::atan2(im_, re_) + 2 * pi * turns_; }

    /// The sum in full turns, if it is known to be a multiple of them.
    int turns() const { return turns_; }

private:
    double re_ = 1, im_ = 0;
    int turns_ = 0;
};

}  // namespace overlap
