// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nanobind/nanobind.h>

// What each topic adds to the extension module.
namespace percolith::python {

void bind_errors(nanobind::module_& module);
void bind_documents(nanobind::module_& module);
void bind_reports(nanobind::module_& module);
void bind_mesh(nanobind::module_& module);
void bind_flow(nanobind::module_& module);
void bind_motion(nanobind::module_& module);
void bind_run(nanobind::module_& module);

}  // namespace percolith::python
