// SPDX-License-Identifier: BSD-3-Clause
// Time from a mesh file of 1e6 triangles to a model that can be computed with.
#include "percolith/mesh/gmsh_reader.hpp"
#include "percolith/seepage/flow_graph.hpp"

#include <fmt/format.h>

#include "bench/support/flow_case.hpp"
#include "bench/support/grid_mesh.hpp"
#include "bench/support/measure.hpp"
#include "bench/support/mesh_file.hpp"
#include "bench/support/results.hpp"

namespace {

using namespace percolith;
using namespace percolith::bench;

void measure(Results& results) {
  constexpr int rounds = 3;
  const std::string content = mesh_file(grid_mesh(cells_for(1'000'000)));
  Best reading;
  Best building;
  Best modelling;
  Best graph;
  for (int round = 0; round < rounds; ++round) {
    const ProcessorClock read_clock;
    const mesh::GmshMesh file = mesh::read_gmsh(content, "grid.msh");
    reading.add(read_clock.seconds());
    const ProcessorClock build_clock;
    const mesh::Mesh mesh = mesh::build_mesh(file);
    building.add(build_clock.seconds());
    const ProcessorClock model_clock;
    const seepage::Model model = make_flow_model(mesh, FlowCase{});
    modelling.add(model_clock.seconds());
    const ProcessorClock graph_clock;
    const seepage::FlowGraph flow_graph = seepage::make_flow_graph(model);
    graph.add(graph_clock.seconds());
  }
  fmt::print("\n1e6 triangles in random order, version 2.2 binary\n");
  const auto row = [&](const char* text, const std::string& name, const Best& best) {
    fmt::print("  {:<44}{:>8.3f} s\n", text, best.value());
    results.report("preparation.1e6." + name, best.value(), "s");
  };
  row("read the file's content", "read", reading);
  row("order and connect the mesh", "build_mesh", building);
  row("model with fractures, initial state", "model", modelling);
  row("flow graph", "flow_graph", graph);
}

}  // namespace

int main(int argc, char** argv) {
  return run_benchmark(argc, argv, measure);
}
