#include "experiments/bounds/cover_program.h"

#include <CbcHeuristic.hpp>
#include <CbcHeuristicRINS.hpp>
#include <CbcModel.hpp>
#include <CglGomory.hpp>
#include <CglKnapsackCover.hpp>
#include <CglZeroHalf.hpp>
#include <ClpSimplex.hpp>
#include <CoinPackedMatrix.hpp>
#include <OsiClpSolverInterface.hpp>
#include <algorithm>
#include <cmath>

#include "experiments/bounds/swap_search.h"

namespace ariadne::experiments {
namespace {

constexpr double kTotal = 1000.0;  // of the weights in the program, as tolerances are absolute

/// Columns: one x per set, then one y per element, which is fixed to 1 where it is mandatory.
OsiClpSolverInterface CoverProgram(const ReducedCover& problem) {
  const int sets = static_cast<int>(problem.sets.size());
  const int elements = static_cast<int>(problem.weights.size());
  CoinPackedMatrix rows(false, 0.0, 0.0);
  rows.setDimensions(0, sets + elements);
  CoinPackedVector weights;
  std::vector<double> lower_y(problem.weights.size(), 0.0);
  for (int i = 0; i < elements; ++i) {
    const auto e = static_cast<std::size_t>(i);
    CoinPackedVector row;
    for (const int set : problem.sets_with[e]) row.insert(set, 1.0);
    row.insert(sets + i, -1.0);
    rows.appendRow(row);
    weights.insert(sets + i, problem.weights[e] * kTotal / problem.total);
    if (problem.Mandatory(e)) lower_y[e] = 1.0;
  }
  rows.appendRow(weights);
  const auto columns = static_cast<std::size_t>(sets) + static_cast<std::size_t>(elements);
  std::vector<double> lower(columns, 0.0), upper(columns, 1.0), cost(columns, 0.0);
  std::copy(lower_y.begin(), lower_y.end(), lower.begin() + sets);
  std::fill(cost.begin(), cost.begin() + sets, 1.0);
  std::vector<double> row_lower(static_cast<std::size_t>(elements) + 1, 0.0);
  row_lower.back() = problem.required * kTotal / problem.total;
  const std::vector<double> row_upper(row_lower.size(), COIN_DBL_MAX);
  OsiClpSolverInterface program;
  program.messageHandler()->setLogLevel(0);
  program.getModelPtr()->setLogLevel(0);
  program.loadProblem(rows, lower.data(), upper.data(), cost.data(), row_lower.data(), row_upper.data());
  for (int s = 0; s < sets; ++s) program.setInteger(s);
  return program;
}

std::vector<double> SolutionOf(const ReducedCover& problem, const std::vector<int>& chosen) {
  std::vector<double> solution(problem.sets.size() + problem.weights.size(), 0.0);
  for (const int set : chosen) {
    solution[static_cast<std::size_t>(set)] = 1.0;
    for (const int i : problem.sets[static_cast<std::size_t>(set)]) {
      solution[problem.sets.size() + static_cast<std::size_t>(i)] = 1.0;
    }
  }
  return solution;
}

std::vector<int> ChosenBy(const double* solution, std::size_t sets) {
  std::vector<int> chosen;
  for (std::size_t s = 0; s < sets; ++s) {
    if (solution[s] > 0.5) chosen.push_back(static_cast<int>(s));
  }
  return chosen;
}

/// What no solution falls below, whatever the prices of the rows are (Lagrange), and whether or not the
/// simplex algorithm came to its end: the rows' lower sides at their prices, and each column at the better
/// of its bounds.
double BoundByPrices(const OsiClpSolverInterface& program) {
  const int rows = program.getNumRows();
  const int columns = program.getNumCols();
  std::vector<double> prices(program.getRowPrice(), program.getRowPrice() + rows);
  for (double& price : prices) price = std::max(0.0, price);
  std::vector<double> paid(static_cast<std::size_t>(columns), 0.0);
  program.getMatrixByCol()->transposeTimes(prices.data(), paid.data());
  double bound = 0.0;
  for (int i = 0; i < rows; ++i) bound += prices[static_cast<std::size_t>(i)] * program.getRowLower()[i];
  for (int j = 0; j < columns; ++j) {
    const double cost = program.getObjCoefficients()[j] - paid[static_cast<std::size_t>(j)];
    bound += cost * (cost < 0.0 ? program.getColUpper()[j] : program.getColLower()[j]);
  }
  return bound;
}

void Search(CbcModel& model, const std::vector<double>& start, double size, const CoverOptions& options) {
  model.setLogLevel(0);
  model.solver()->setHintParam(OsiDoReducePrint, true, OsiHintTry);
  CglZeroHalf zero_half;
  CglKnapsackCover knapsack;
  CglGomory gomory;
  model.addCutGenerator(&zero_half, -1, "ZeroHalf");
  model.addCutGenerator(&knapsack, -1, "Knapsack");
  model.addCutGenerator(&gomory, -1, "Gomory");
  CbcRounding rounding(model);
  model.addHeuristic(&rounding);
  CbcHeuristicRINS neighborhood(model);
  model.addHeuristic(&neighborhood);
  model.setBestSolution(start.data(), static_cast<int>(start.size()), size);
  model.setCutoffIncrement(0.999);  // sizes are whole numbers
  model.setMaximumNodes(options.max_nodes);
  model.setMaximumNumberIterations(options.max_iterations);
  model.setMaximumSeconds(options.max_seconds);
  model.setMaximumCutPassesAtRoot(10);
  model.setMaximumCutPasses(1);
  model.setRandomSeed(1);
  model.branchAndBound();
}

/// Bounds by the simplex algorithm are rounded.
int RoundedUp(double bound) { return std::max(1, static_cast<int>(std::ceil(bound - 1e-5))); }

}  // namespace

CoverProgramResult SolveCoverProgram(const ReducedCover& problem, const std::vector<int>& start,
                                     const CoverOptions& options) {
  OsiClpSolverInterface program = CoverProgram(problem);
  program.getModelPtr()->setMaximumSeconds(options.max_seconds);
  program.setHintParam(OsiDoDualInInitial, false);  // three times faster than the dual one
  program.initialSolve();
  CoverProgramResult result;
  result.relaxation = BoundByPrices(program);
  result.bound = RoundedUp(result.relaxation);
  result.chosen = SwapSearch(problem, start, result.bound, options.swaps);
  const auto size = static_cast<int>(result.chosen.size());
  if (options.max_nodes == 0 || result.bound >= size || !program.isProvenOptimal()) return result;
  CbcModel model(program);
  Search(model, SolutionOf(problem, result.chosen), size, options);
  // Where time ended the search, CBC's bound may be the incumbent's size, proven or not.
  if (model.getCurrentSeconds() < options.max_seconds && !model.isSecondsLimitReached()) {
    result.bound = std::max(result.bound, RoundedUp(model.getBestPossibleObjValue()));
  }
  if (model.bestSolution() == nullptr) return result;
  const std::vector<int> found = ChosenBy(model.bestSolution(), problem.sets.size());
  if (found.size() < result.chosen.size()) result.chosen = found;
  return result;
}

}  // namespace ariadne::experiments
