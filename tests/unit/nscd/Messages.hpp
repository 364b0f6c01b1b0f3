// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <stdexcept>
#include <string>

/// Message of the exception of type E that an action throws.
template <class E, class Action>
std::string messageOf(Action&& action)
{
    try
    {
        action();
    }
    catch (const E& error)
    {
        return error.what();
    }
    return "nothing was thrown";
}

template <class Action>
std::string invalid(Action&& action)
{
    return messageOf<std::invalid_argument>(action);
}
