// SPDX-License-Identifier: BSD-3-Clause
// Operations per second, in random order, on trees with different children.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>

#include "test/benchmark/surface_tree.hpp"

namespace multimesh::bench {
namespace {

using ::benchmark::Counter;

std::vector<Index> shuffled(Index n) {
  std::vector<Index> order(n);
  std::iota(order.begin(), order.end(), Index{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  return order;
}

bool split(SurfaceTree& t, Dart e) {
  return bool(t.operations().split(NodeId::root, e));
}
bool collapse(SurfaceTree& t, Dart e) {
  return bool(t.operations().collapse(NodeId::root, e));
}
bool swap(SurfaceTree& t, Dart e) {
  return bool(t.operations().swap(NodeId::root, e));
}
bool relocate(SurfaceTree& t, Dart v) {
  const Index i = t.root().vertex(v);
  const OpenMesh::Vec3d moved = t.positions()[i] + OpenMesh::Vec3d(1e-6, 0, 0);
  return bool(
      t.operations().relocate(NodeId::root, v, [&](const Event&) { t.position_attribute().set(i, moved); }));
}

/// Requests the operation on a quarter of the k-simplices, each in turn, leaving out those that died.
template <bool (*operation)(SurfaceTree&, Dart), int k>
void run(::benchmark::State& state, unsigned children) {
  const auto n = static_cast<Index>(state.range(0)), m = static_cast<Index>(state.range(1));
  const ChartedShape charted = children & boundary ? charted_grid(n, m) : charted_torus(n, m);
  std::size_t tried = 0, done = 0;
  for (auto _ : state) {
    state.PauseTiming();
    std::optional<SurfaceTree> tree(std::in_place, charted, children);
    auto order = shuffled(tree->root().capacity(k));
    order.resize(order.size() / 4);
    state.ResumeTiming();
    for (const Index s : order) {
      if (!tree->root().is_live(k, s)) continue;
      ++tried;
      done += operation(*tree, tree->root().dart_of(k, s));
    }
    state.PauseTiming();
    tree.reset();
    state.ResumeTiming();
  }
  state.counters["faces"] = static_cast<double>(charted.shape.facets.size());
  state.counters["refused"] = 1 - static_cast<double>(done) / static_cast<double>(tried);
  state.counters["ops/s"] = Counter(static_cast<double>(done), Counter::kIsRate);
  state.counters["time/op"] = Counter(static_cast<double>(done), Counter::kIsRate | Counter::kInvert);
}

template <bool (*operation)(SurfaceTree&, Dart), int k>
void add_benchmarks(const std::string& name) {
  const auto add = [&](const std::string& variant, unsigned children) {
    auto* b = ::benchmark::RegisterBenchmark((name + "/" + variant).c_str(), run<operation, k>, children);
    // 2,048 to 1,048,576 faces, x8 apart.
    b->Args({32, 32})->Args({128, 64})->Args({256, 256})->Args({1024, 512})->Unit(::benchmark::kMillisecond);
  };
  add("root", alone);
  add("uv", texture);
  add("uv+seams", texture | seams);
  add("boundary", boundary);
}

}  // namespace
}  // namespace multimesh::bench

int main(int argc, char** argv) {
  using namespace multimesh::bench;
  add_benchmarks<split, 1>("split");
  add_benchmarks<collapse, 1>("collapse");
  add_benchmarks<swap, 1>("swap");
  add_benchmarks<relocate, 0>("relocate");
  ::benchmark::Initialize(&argc, argv);
  if (::benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  ::benchmark::RunSpecifiedBenchmarks();
}
