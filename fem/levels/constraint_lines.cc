#include "fem/levels/constraint_lines.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "core/threads.h"

namespace asperity::fem {
namespace {

// Some microseconds of work.
constexpr int nodes_of_a_part = 1000;

}  // namespace

void ConstraintLines::add_line(int constrained) {
  constrained_.push_back(constrained);
  start_.push_back(start_.back());
}

int ConstraintLines::add_entry(int free, double weight) {
  free_.push_back(free);
  weight_.push_back(weight);
  return start_.back()++;
}

ConstraintLines::Part ConstraintLines::all() const {
  std::vector<int> lines(constrained_.size());
  std::iota(lines.begin(), lines.end(), 0);
  return part(lines);
}

bool ConstraintLines::is_of_node(std::size_t line) const {
  if (line + 2 >= constrained_.size() || constrained_[line] % 3 != 0) return false;
  const int first = start_[line], entries = start_[line + 1] - first;
  if (entries == 0) return false;
  for (int c = 0; c < 3; ++c) {
    if (constrained_[line + c] != constrained_[line] + c ||
        start_[line + c + 1] - start_[line + c] != entries)
      return false;
    for (int e = 0; e < entries; ++e) {
      const double weight = weight_[first + e];
      if (free_[first + e] % 3 != 0 || free_[first + c * entries + e] != free_[first + e] + c ||
          weight_[first + c * entries + e] != weight ||
          static_cast<double>(static_cast<float>(weight)) != weight)
        return false;
    }
  }
  return true;
}

ConstraintLines::Part::Part(const ConstraintLines& all, const std::vector<int>& lines) : all_(&all) {
  const auto follows = [&](std::size_t k, int c) {
    return k + c < lines.size() && lines[k + c] == lines[k] + c;
  };
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const int line = lines[k];
    if (!follows(k, 1) || !follows(k, 2) || !all.is_of_node(line)) {
      single_.push_back(line);
      continue;
    }
    hanging_.node.push_back(all.constrained_[line] / 3);
    for (int e = all.start_[line]; e < all.start_[line + 1]; ++e)
      hanging_.entry.push_back({all.free_[e] / 3, static_cast<float>(all.weight_[e])});
    hanging_.start.push_back(static_cast<int>(hanging_.entry.size()));
    k += 2;
  }
  receiving_ = hanging_.transposed();
}

ConstraintLines::Part::NodeSums ConstraintLines::Part::NodeSums::transposed() const {
  struct Whole {
    int free, constrained;
    float weight;
  };
  std::vector<Whole> all;
  for (std::size_t k = 0; k < node.size(); ++k)
    for (int e = start[k]; e < start[k + 1]; ++e) all.push_back({entry[e].node, node[k], entry[e].weight});
  std::stable_sort(all.begin(), all.end(), [](const Whole& a, const Whole& b) { return a.free < b.free; });
  NodeSums sums;
  for (const Whole& one : all) {
    if (sums.node.empty() || sums.node.back() != one.free) {
      sums.node.push_back(one.free);
      sums.start.push_back(sums.start.back());
    }
    sums.entry.push_back({one.constrained, one.weight});
    ++sums.start.back();
  }
  return sums;
}

void ConstraintLines::condense_diagonal(double* y) const {
  for (std::size_t c = 0; c < constrained_.size(); ++c) {
    const double value = y[constrained_[c]];
    y[constrained_[c]] = 0;
    for (int e = start_[c]; e < start_[c + 1]; ++e) y[free_[e]] += weight_[e] * weight_[e] * value;
  }
}

template <typename Number>
void ConstraintLines::Part::NodeSums::add(int place, const Number* values, Number (&sum)[3]) const {
  for (int e = start[place]; e < start[place + 1]; ++e) {
    const Number* value = values + 3 * static_cast<std::ptrdiff_t>(entry[e].node);
    const Number weight = entry[e].weight;
    for (int c = 0; c < 3; ++c) sum[c] += weight * value[c];
  }
}

template <typename Number>
void ConstraintLines::Part::distribute(Number* x) const {
  for_parts(static_cast<int>(hanging_.node.size()), nodes_of_a_part, [&](int first, int last) {
    for (int k = first; k < last; ++k) {
      Number sum[3] = {0, 0, 0};
      hanging_.add(k, x, sum);
      for (int c = 0; c < 3; ++c) x[3 * static_cast<std::ptrdiff_t>(hanging_.node[k]) + c] = sum[c];
    }
  });
  for (const int line : single_) {
    Number sum = 0;
    for (int e = all_->start_[line]; e < all_->start_[line + 1]; ++e)
      sum += static_cast<Number>(all_->weight_[e]) * x[all_->free_[e]];
    x[all_->constrained_[line]] = sum;
  }
}

template <typename Number>
void ConstraintLines::Part::condense(Number* y) const {
  for (const int line : single_) {
    Number& value = y[all_->constrained_[line]];
    for (int e = all_->start_[line]; e < all_->start_[line + 1]; ++e)
      y[all_->free_[e]] += static_cast<Number>(all_->weight_[e]) * value;
    value = 0;
  }
  for_parts(static_cast<int>(receiving_.node.size()), nodes_of_a_part, [&](int first, int last) {
    for (int k = first; k < last; ++k) {
      Number* target = y + 3 * static_cast<std::ptrdiff_t>(receiving_.node[k]);
      Number sum[3] = {target[0], target[1], target[2]};
      receiving_.add(k, y, sum);
      for (int c = 0; c < 3; ++c) target[c] = sum[c];
    }
  });
  for_parts(static_cast<int>(hanging_.node.size()), nodes_of_a_part, [&](int first, int last) {
    for (int k = first; k < last; ++k)
      for (int c = 0; c < 3; ++c) y[3 * static_cast<std::ptrdiff_t>(hanging_.node[k]) + c] = 0;
  });
}

template void ConstraintLines::Part::distribute(double*) const;
template void ConstraintLines::Part::distribute(float*) const;
template void ConstraintLines::Part::condense(double*) const;
template void ConstraintLines::Part::condense(float*) const;

}  // namespace asperity::fem
