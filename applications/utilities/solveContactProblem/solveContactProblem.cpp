// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Solve a frictional contact problem of an FCLIB file; see 'usage' below.

#include "nscd/problem/Fclib.hpp"
#include "nscd/problem/SparseSolve.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <string>

namespace
{

const char* const usage =
    "Usage: solveContactProblem FILE.hdf5 [OPTION]\n"
    "\n"
    "Solve a frictional contact problem (FCLIB, fclib_local, in two or three\n"
    "dimensions) and write impulses and velocities to its group 'solution'.\n"
    "Starts from the first of the file's guesses, if there are any.\n"
    "\n"
    "  -solver NAME       sweeps     plain Gauss-Seidel\n"
    "                     queue      only contacts where something has changed\n"
    "                     nesterov   Gauss-Seidel with momentum (default)\n"
    "  -tolerance VALUE   largest scaled natural map of a contact [m/s] (1e-6)\n"
    "  -maxSweeps N       work after which to give up, in solutions of single\n"
    "                     contacts over the number of contacts (100000)\n"
    "  -output FILE       write the problem with its solution to another file\n"
    "  -help              print this\n"
    "\n"
    "Exit code 1, and nothing written, where the tolerance is not reached.\n";

struct Options
{
    std::string file, output;
    nscd::Solver solver = nscd::Solver::nesterov;
    std::string solverName = "nesterov";
    nscd::SolveLimits limits;
    bool help = false;
};

double toNumber(const std::string& option, const std::string& word)
{
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0')
    {
        nscd::refuse(option, " needs a number, not '", word, "'");
    }
    return value;
}

int toCount(const std::string& option, const std::string& word)
{
    const double value = toNumber(option, word);
    if (!(value >= 0 && value <= std::numeric_limits<int>::max()) || value != static_cast<int>(value))
    {
        nscd::refuse(option, " needs a whole number, 0 or more, not '", word, "'");
    }
    return static_cast<int>(value);
}

Options parse(int argc, char** argv)
{
    Options options;
    for (int k = 1; k < argc; ++k)
    {
        const std::string word = argv[k];
        const auto value = [&]() -> std::string
        {
            if (k + 1 == argc)
            {
                nscd::refuse("option ", word, " needs a value");
            }
            return argv[++k];
        };
        if (word == "-help")
        {
            options.help = true;
        }
        else if (word == "-solver")
        {
            options.solverName = value();
            options.solver = nscd::solverOfName(options.solverName);
        }
        else if (word == "-tolerance")
        {
            options.limits.tolerance = toNumber(word, value());
        }
        else if (word == "-maxSweeps")
        {
            options.limits.maxSweeps = toCount(word, value());
        }
        else if (word == "-output")
        {
            options.output = value();
        }
        else if (word.size() > 1 && word[0] == '-')
        {
            nscd::refuse("unknown option ", word, "; see solveContactProblem -help");
        }
        else if (options.file.empty())
        {
            options.file = word;
        }
        else
        {
            nscd::refuse("one file at a time, not also ", word);
        }
    }
    if (options.file.empty() && !options.help)
    {
        nscd::refuse("which file? See solveContactProblem -help");
    }
    return options;
}

void print(const char* when, const nscd::Residual& r)
{
    std::printf("    %-8s %12.4e %12.4e %12.4e\n", when, r.worst, r.relative, r.penetration);
}

/// True when the tolerance was reached.
template <int D>
bool solve(const Options& options, const nscd::FclibProblem<D>& p)
{
    const nscd::SparseProblem<D>& problem = p.problem;
    const nscd::Vectors<D> start =
        p.guesses.empty() ? nscd::Vectors<D>(problem.contacts(), nscd::Vector<D>::Zero()) : p.guesses.front().r;
    std::printf("%s\n", options.file.c_str());
    std::printf("    contacts     %d in %d dimensions, %zu blocks of W\n", problem.contacts(), D, problem.blocks());
    if (problem.contacts() > 0)
    {
        const auto [least, most] = std::minmax_element(problem.friction().begin(), problem.friction().end());
        std::printf("    mu           %g to %g\n", *least, *most);
    }
    std::printf("    start        %s\n", p.guesses.empty() ? "zero" : "guess 1");
    std::printf("    solver       %s, tolerance %g m/s, at most %d sweeps\n\n", options.solverName.c_str(),
                options.limits.tolerance, options.limits.maxSweeps);
    std::printf("             scaled natural map         approach\n");
    std::printf("             worst [m/s]  rms/q_N rms  worst [m/s]\n");
    print("before", residual(problem, start));
    std::fflush(stdout);

    const nscd::SparseSolution<D> s = nscd::solve<D>(problem, options.solver, options.limits, start);
    print("after", s.residual);
    std::printf("\n    sweeps       %.1f\n    CPU seconds  %.3f, %.2f million contacts per second\n", s.sweeps,
                s.cpuSeconds, 1e-6 * s.sweeps * problem.contacts() / std::max(s.cpuSeconds, 1e-6));
    if (!s.converged)
    {
        std::fprintf(stderr,
                     "solveContactProblem: not converged: %.4e m/s after %.1f sweeps, tolerance %g m/s. Nothing is "
                     "written. Try more with -maxSweeps, another -solver or a larger -tolerance.\n",
                     s.residual.worst, s.sweeps, options.limits.tolerance);
        return false;
    }
    const std::string output = options.output.empty() ? options.file : options.output;
    nscd::writeFclibSolution<D>(options.file, output, {s.r, problem.velocities(s.r)});
    std::printf("\nWrote solution to %s\n", output.c_str());
    return true;
}

}  // namespace

int main(int argc, char** argv)
{
    try
    {
        const char* const ranks = std::getenv("OMPI_COMM_WORLD_SIZE");
        if (ranks && std::string(ranks) != "1")
        {
            nscd::refuse("runs on one core; start it without mpirun, not on ", ranks, " ranks");
        }
        const Options options = parse(argc, argv);
        if (options.help)
        {
            std::fputs(usage, stdout);
            return 0;
        }
        const auto problem = nscd::readFclib(options.file);
        return std::visit([&](const auto& p) { return solve(options, p); }, problem) ? 0 : 1;
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "solveContactProblem: %s\n", error.what());
        return 1;
    }
}
