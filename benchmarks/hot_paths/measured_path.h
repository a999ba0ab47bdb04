// One path of hot_paths and how it is measured.
#pragma once

#include <benchmark/benchmark.h>

namespace asperity::hot_paths {

/// Shortest of three repetitions of 0.2 s and more, in real time.
void add(const char* name, void (*run)(benchmark::State&));

/// What one iteration went through (unknowns, points, pixels) and, if told, the least traffic to memory
/// [bytes]: the times that are compared are per item.
void count(benchmark::State& state, double items, double bytes = 0);

// Each registers the paths of its file.
void add_operators();
void add_material_points();
void add_set_up();
void add_surfaces();

}  // namespace asperity::hot_paths
