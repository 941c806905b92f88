// SPDX-License-Identifier: BSD-3-Clause
#include "percolith/version.hpp"

#include "modules.hpp"

// The extension module of the package. What users meet is written in Python around it; here are the
// parts that only C++ has.
NB_MODULE(_core, module) {
  namespace build = percolith::build;
  module.doc() = "The simulator itself. Use the names that the package `percolith` gives.";
  module.attr("version") = nanobind::str(build::version.data(), build::version.size());
  module.attr("revision") = nanobind::str(build::revision.data(), build::revision.size());
  percolith::python::bind_errors(module);
  percolith::python::bind_documents(module);
  percolith::python::bind_reports(module);
  percolith::python::bind_mesh(module);
  percolith::python::bind_flow(module);
  percolith::python::bind_motion(module);
  percolith::python::bind_run(module);
}
