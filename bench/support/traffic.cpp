// SPDX-License-Identifier: BSD-3-Clause
#include "bench/support/traffic.hpp"

#include <vector>

namespace percolith::bench {
namespace {

using mesh::Index;

constexpr std::size_t line = 64;

/// Counts the distinct cache lines of an array that a phase touches.
class Touched {
public:
  Touched(std::size_t entries, std::size_t entry_bytes)
      : entry_bytes_(entry_bytes), seen_(entries * entry_bytes / line + 1, 0) {}
  void touch(Index entry) { seen_[static_cast<std::size_t>(entry) * entry_bytes_ / line] = 1; }
  [[nodiscard]] double bytes() const {
    double sum = 0.0;
    for (const std::uint8_t s : seen_) {
      sum += s != 0 ? line : 0.0;
    }
    return sum;
  }

private:
  std::size_t entry_bytes_;
  std::vector<std::uint8_t> seen_;
};

/// Lines of a per-corner array of numbers in which a node's leader lies.
double leader_bytes(const seepage::Model& model) {
  Touched touched(static_cast<std::size_t>(model.mesh.corners()), sizeof(double));
  for (const Index node : model.pore_nodes.nodes(model.mesh)) {
    touched.touch(node);
  }
  return touched.bytes();
}

/// Lines of per-joint records of `record_bytes` that belong to broken joints.
double broken_bytes(const seepage::Model& model, std::size_t record_bytes) {
  Touched touched(model.mesh.joint.size(), record_bytes);
  for (const Index j : model.cracks.broken_joints()) {
    touched.touch(j);
  }
  return touched.bytes();
}

/// Lines of a per-corner array of numbers that hold corners at crack faces.
double face_bytes(const seepage::Model& model) {
  Touched touched(static_cast<std::size_t>(model.mesh.corners()), sizeof(double));
  for (const Index j : model.cracks.broken_joints()) {
    for (const auto& side : model.mesh.joint[static_cast<std::size_t>(j)].corner) {
      touched.touch(side[0]);
      touched.touch(side[1]);
    }
  }
  return touched.bytes();
}

/// Lines of a per-vertex array of numbers that hold open crack nodes.
double open_node_bytes(const seepage::Model& model) {
  Touched touched(model.mesh.vertex.size(), sizeof(double));
  for (const Index v : model.cracks.open_nodes()) {
    touched.touch(v);
  }
  return touched.bytes();
}

template <class T>
double size_of(const std::vector<T>& list) {
  return static_cast<double>(list.size() * sizeof(T));
}

}  // namespace

std::map<std::string, double> step_traffic(const seepage::Model& model) {
  constexpr double read = 1.0;
  constexpr double write = 2.0;
  const bool finite = !model.pore.joint.empty();
  const double corner = size_of(model.state.pressure);
  const double corner_index = corner / sizeof(double) * sizeof(Index);
  const double leader = leader_bytes(model);
  const double face = face_bytes(model);
  const double node = open_node_bytes(model);
  const double broken = static_cast<double>(model.cracks.broken_joints().size());
  std::map<std::string, double> bytes;
  // pressure, saturation, conductance, lift; inflow
  bytes["pore flow"] = (4.0 * read + write) * corner;
  // pressure, saturation, conductance; both corners across; inflow
  bytes["joint flow"] = finite ? (3.0 * read + write) * corner + 2.0 * read * corner_index : 0.0;
  // the joint, conductance, exchange; pressure and saturation of faces and crack nodes, lift;
  // four exchange flows and one crack flow; then per face its number, two places and the inflow
  bytes["crack flow"] = broken_bytes(model, sizeof(mesh::Joint)) +
                        2.0 * broken_bytes(model, sizeof(double)) + 2.0 * face + 3.0 * node +
                        broken * (write * 5.0 * sizeof(double) + 4.0 * 3.0 * sizeof(Index) +
                                  read * 4.0 * sizeof(double)) +
                        write * face;
  if (finite) {
    // inflow, storage, void volume; content, carry, pressure, saturation
    bytes["pore contents"] = (3.0 * read + 4.0 * write) * corner;
  } else {
    // corners, storage and void volume of each node; inflow, pressure; of the leaders saturation,
    // content and carry
    bytes["pore contents"] = size_of(model.mesh.vertex_corners.entry) +
                             2.0 * sizeof(double) * static_cast<double>(model.mesh.vertices()) +
                             (read + write) * corner + (read + 2.0 * write) * leader;
  }
  // number and joint ends of each node, the flows; content, carry, pressure, saturation, volume
  bytes["crack contents"] = broken * (2.0 * sizeof(Index) + 5.0 * sizeof(double)) +
                            (4.0 * write + read) * node + 2.0 * broken * sizeof(Index);
  return bytes;
}

std::size_t step_footprint(const seepage::Model& model) {
  // pressure, saturation, conductance, lift, inflow, content, carry, storage, void volume
  double bytes = 9.0 * size_of(model.state.pressure) + size_of(model.mesh.vertex_corners.start) +
                 size_of(model.mesh.vertex_corners.entry);
  if (!model.pore.joint.empty()) {
    // conductance and both corners across
    bytes += 2.0 * size_of(model.state.pressure);
  }
  return static_cast<std::size_t>(bytes);
}

}  // namespace percolith::bench
