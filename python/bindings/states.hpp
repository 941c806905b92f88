// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "percolith/mechanics/model.hpp"
#include "percolith/runner/case_run.hpp"
#include "percolith/seepage/model.hpp"

#include <memory>

// What of a run can be looked at. Each keeps the run alive.
namespace percolith::python {

struct MeshView {
  std::shared_ptr<runner::CaseRun> run;
  const mesh::Mesh* mesh;
};

struct FlowView {
  std::shared_ptr<runner::CaseRun> run;
  const seepage::Model* model;
};

struct MotionView {
  std::shared_ptr<runner::CaseRun> run;
  const mechanics::Model* model;
};

}  // namespace percolith::python
