// SPDX-License-Identifier: BSD-3-Clause
// The laws that kernels call, compiled for a GPU: 100,000 random inputs must give what the serial
// reference gives, up to a share of 1e-12 of the largest value. Skipped where there is no GPU.
#include "percolith/material/elasticity.hpp"
#include "percolith/material/friction.hpp"
#include "percolith/material/joint_law.hpp"
#include "percolith/mechanics/contact/overlap_force.hpp"
#include "percolith/mechanics/joint.hpp"
#include "percolith/mechanics/triangle.hpp"
#include "percolith/seepage/content.hpp"
#include "percolith/seepage/crack.hpp"
#include "percolith/seepage/pore.hpp"
#include "percolith/seepage/pore_flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace {

using namespace percolith;
constexpr int samples = 100'000;
constexpr int inputs = 16;
constexpr int outputs = 8;

/// Each law as a function from `inputs` numbers in [-1, 1] to `outputs` numbers.
struct JointLaw {
  PERCOLITH_DEVICE void operator()(const double* in, double* out) const {
    const material::JointConstants<double> c{1e12, 5e6, 15e6, 0.6, 1e4, 1e4};
    material::JointMemory<double> memory{1e-4 * (in[2] + 1.0), 1e-4 * (in[3] + 1.0),
                                         in[4] > 0.0 ? 0.9 * in[4] : 0.0,
                                         1e11 * (in[8] + 1.0),
                                         1e6 * in[9],
                                         1e-5 * in[10]};
    const auto t = material::softening_traction(c, 1e-4 * in[0], 1e-4 * in[1], memory);
    out[0] = t.normal;
    out[1] = t.shear;
    out[2] = memory.opening_peak;
    out[3] = memory.slip_peak;
    out[4] = memory.damage;
    out[5] = material::stored_energy(
        c, material::moment_of(c, 1e-4 * in[0], 1e-4 * in[1], t, memory));
    out[6] = material::softening(0.5 * (in[5] + 1.0));
    const auto slid = material::friction_step(1e6 * in[6], 1e9, 1e-3 * in[7], 5e5);
    out[7] = slid.force + slid.loss;
  }
};

struct JointLossLaw {
  PERCOLITH_DEVICE void operator()(const double* in, double* out) const {
    const material::JointConstants<double> c{1e12, 5e6, 15e6, 0.6, 1e4, 1e4};
    // Half of the points were whole before, half of them are under compression.
    material::JointMemory<double> memory{
        1e-4, 1e-4, in[0] > 0.0 ? 0.9 * in[0] : 0.0, 1e11, 1e6 * in[5], 1e-5 * in[6]};
    const auto first = material::softening_traction(c, 1e-4 * in[3], 1e-4 * in[4], memory);
    const auto before = material::moment_of(c, 1e-4 * in[3], 1e-4 * in[4], first, memory);
    const auto t = material::softening_traction(c, 1e-4 * in[1], 1e-4 * in[2], memory);
    const auto now = material::moment_of(c, 1e-4 * in[1], 1e-4 * in[2], t, memory);
    const auto loss = material::joint_loss(c, before, now);
    out[0] = loss.bond;
    out[1] = loss.friction;
    out[2] = memory.friction;
    out[3] = material::moment_at_peak(c, now).friction;
    for (int k = 4; k < outputs; ++k) {
      out[k] = 0.0;
    }
  }
};

struct TriangleLaw {
  PERCOLITH_DEVICE void operator()(const double* in, double* out) const {
    const auto shape = mechanics::triangle_shape(Point{1.0 + 0.2 * in[0], 0.2 * in[1]},
                                                 Point{0.2 * in[2], 1.0 + 0.2 * in[3]});
    const auto h = mechanics::gradient_of(shape, Point{in[4], in[5]}, Point{in[6], in[7]});
    const material::PlaneStiffness<double> d{30e9, 10e9, 25e9, 1e9, -1e9, 8e9};
    auto s = material::stress_of(d, mechanics::green_strain(h));
    const auto rate = mechanics::gradient_of(shape, Point{in[8], in[9]}, Point{in[10], in[11]});
    s.xx += 1e9 * mechanics::green_strain_rate(h, rate).xx;
    const auto f = mechanics::corner_forces(shape, h, s);
    for (int k = 0; k < 3; ++k) {
      out[2 * k] = f[static_cast<std::size_t>(k)].x;
      out[2 * k + 1] = f[static_cast<std::size_t>(k)].y;
    }
    const auto sigma = mechanics::cauchy_stress(
        {{0.1 * h.x.x, 0.1 * h.x.y}, {0.1 * h.y.x, 0.1 * h.y.y}}, {s.xx, s.yy, s.xy});
    out[6] = sigma.xx + sigma.yy;
    out[7] = sigma.xy;
  }
};

/// What fluid does to rock and rock to fluid: pressure in triangles, growth of their pores, and a
/// fracture that its stress closes.
struct CoupledLaw {
  PERCOLITH_DEVICE void operator()(const double* in, double* out) const {
    const Point a{1.0 + 0.2 * in[0], 0.2 * in[1]};
    const Point b{0.2 * in[2], 1.0 + 0.2 * in[3]};
    const auto f = mechanics::pressure_forces(a, b, 1e6 * in[4]);
    for (int k = 0; k < 2; ++k) {
      out[2 * k] = f[static_cast<std::size_t>(k)].x;
      out[2 * k + 1] = f[static_cast<std::size_t>(k)].y;
    }
    out[4] = mechanics::area_growth(a, b, Point{in[5], in[6]}, Point{in[7], in[8]});
    const material::Fracture fracture{.initial_aperture = 1e-4,
                                      .minimum_aperture = 1e-5,
                                      .maximum_aperture = 3e-4,
                                      .closure_stress = 1e7};
    const double compression = 1e7 * (in[9] + 1.0);
    const double aperture = seepage::hydraulic_aperture(fracture, 4e-4 * in[10], compression);
    out[5] = aperture;
    out[6] = seepage::storage_aperture(fracture, 4e-4 * in[10], compression);
    out[7] = seepage::crack_conductance(fracture, aperture, 1.5 + in[11], 1e-3);
  }
};

struct JointForceLaw {
  PERCOLITH_DEVICE void operator()(const double* in, double* out) const {
    std::array<std::array<Point, 2>, 2> u;
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t end = 0; end < 2; ++end) {
        u[side][end] = {0.3 * in[4 * side + 2 * end], 0.3 * in[4 * side + 2 * end + 1]};
      }
    }
    const auto place = mechanics::joint_place(Point{1.0, 0.3 * in[8]}, u);
    std::array<material::JointTraction<double>, 2> t;
    for (std::size_t g = 0; g < 2; ++g) {
      const Point apart = mechanics::apart_at(place, g);
      t[g] = material::elastic_traction(1e9, dot(apart, place.across), dot(apart, place.along));
    }
    const auto f = mechanics::joint_forces(place, 1.0, t);
    out[0] = f[0].x;
    out[1] = f[0].y;
    out[2] = f[1].x;
    out[3] = f[1].y;
    out[4] = place.along.x;
    out[5] = place.across.x;
    out[6] = 0.0;
    out[7] = 0.0;
  }
};

/// Two triangles that mostly overlap: the force of contact, where it acts and how deep it goes.
struct ContactLaw {
  PERCOLITH_DEVICE void operator()(const double* in, double* out) const {
    const auto triangle = [&](int first, double x, double y) {
      return std::array<Point, 3>{Point{x + 0.2 * in[first], y + 0.2 * in[first + 1]},
                                  Point{x + 1.0 + 0.2 * in[first + 2], y + 0.2 * in[first + 3]},
                                  Point{x + 0.2 * in[first + 4], y + 1.0 + 0.2 * in[first + 5]}};
    };
    const mechanics::PairPlaces<double> pair{triangle(0, 0.0, 0.0),
                                             triangle(6, 0.5 * in[12], 0.5 * in[13])};
    const std::array<double, 2> area{mechanics::twice_area(pair.first),
                                     mechanics::twice_area(pair.second)};
    const auto force = mechanics::overlap_force(pair, mechanics::pair_sides(pair), area, {1e9, 2e9});
    out[0] = force.total.x;
    out[1] = force.total.y;
    out[2] = force.on[0][1].x;
    out[3] = force.on[1][2].y;
    out[4] = force.centre[0][0];
    out[5] = force.centre[1][1];
    out[6] = mechanics::extent_along(force, Point{0.6, 0.8});
    out[7] = force.on[1][0].x;
  }
};

struct FlowLaw {
  PERCOLITH_DEVICE void operator()(const double* in, double* out) const {
    const std::array<Point, 3> p{Point{0.0, 0.0}, Point{1.0 + 0.2 * in[0], 0.2 * in[1]},
                                 Point{0.2 * in[2], 1.0 + 0.2 * in[3]}};
    const auto c = seepage::pair_conductances(p, Tensor{1e-13, 2e-13, 1e-14}, 1e-3);
    out[0] = c[0] * 1e10;
    out[1] = c[1] * 1e10;
    const Point q = seepage::darcy_flux(p, {in[4], in[5], in[6]});
    out[2] = q.x;
    out[3] = q.y;
    out[4] = seepage::pair_flow(2.0, in[7], 0.5 + 0.5 * in[8], 0.5 + 0.5 * in[9]);
    const auto fluid = seepage::fluid_state(in[10], 0.1 * in[11], 1.5, 2.0, 0.0, true);
    out[5] = fluid.pressure;
    out[6] = fluid.saturation;
    out[7] = seepage::joint_exchange(100.0, 1e-13, 0.1, 2e-13, 0.2, 1e-3) * 1e7;
  }
};

template <class Law>
__global__ void evaluate(Law law, const double* in, double* out) {
  const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
  if (i < samples) {
    law(in + i * inputs, out + i * outputs);
  }
}

/// Memory of the device, freed with its owner.
class DeviceArray {
public:
  explicit DeviceArray(std::size_t count) {
    EXPECT_EQ(cudaMalloc(&data_, count * sizeof(double)), cudaSuccess);
  }
  DeviceArray(const DeviceArray&) = delete;
  DeviceArray& operator=(const DeviceArray&) = delete;
  ~DeviceArray() { cudaFree(data_); }
  [[nodiscard]] double* data() const { return data_; }

private:
  double* data_ = nullptr;
};

template <class Law>
void compare(const Law& law) {
  int devices = 0;
  if (cudaGetDeviceCount(&devices) != cudaSuccess || devices == 0) {
    GTEST_SKIP() << "no GPU on this machine";
  }
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<double> in(static_cast<std::size_t>(samples) * inputs);
  for (double& value : in) {
    value = number(random);
  }
  const auto size = static_cast<std::size_t>(samples) * outputs;
  std::vector<double> expected(size);
  for (int i = 0; i < samples; ++i) {
    law(in.data() + i * inputs, expected.data() + i * outputs);
  }
  const DeviceArray device_in(in.size());
  const DeviceArray device_out(size);
  cudaMemcpy(device_in.data(), in.data(), in.size() * sizeof(double), cudaMemcpyHostToDevice);
  evaluate<<<(samples + 255) / 256, 256>>>(law, device_in.data(), device_out.data());
  std::vector<double> result(size);
  ASSERT_EQ(cudaMemcpy(result.data(), device_out.data(), size * sizeof(double),
                       cudaMemcpyDeviceToHost),
            cudaSuccess);
  for (int k = 0; k < outputs; ++k) {
    double scale = 0.0;
    double error = 0.0;
    for (int i = 0; i < samples; ++i) {
      const auto place = static_cast<std::size_t>(i * outputs + k);
      scale = std::max(scale, std::abs(expected[place]));
      error = std::max(error, std::abs(result[place] - expected[place]));
    }
    EXPECT_LE(error, 1e-12 * scale) << "output " << k;
  }
}

TEST(LawsOnGpu, Joint) {
  compare(JointLaw{});
}

TEST(LawsOnGpu, JointLoss) {
  compare(JointLossLaw{});
}

TEST(LawsOnGpu, Triangle) {
  compare(TriangleLaw{});
}

TEST(LawsOnGpu, JointForces) {
  compare(JointForceLaw{});
}

TEST(LawsOnGpu, Contact) {
  compare(ContactLaw{});
}

TEST(LawsOnGpu, Coupled) {
  compare(CoupledLaw{});
}

TEST(LawsOnGpu, Flow) {
  compare(FlowLaw{});
}

}  // namespace
