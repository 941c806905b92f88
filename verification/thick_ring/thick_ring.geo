// SPDX-License-Identifier: BSD-3-Clause
// A quarter of a ring from r = 1 m to r = 3 m. size: element size, m.
// gmsh -2 -format msh41 -bin -setnumber size 0.4 -o thick_ring_40.msh thick_ring.geo
// and with 0.2 and 0.1 as thick_ring_20.msh and thick_ring_10.msh
DefineConstant[ size = 0.2 ];
Point(1) = {0, 0, 0, size};
Point(2) = {1, 0, 0, size};
Point(3) = {3, 0, 0, size};
Point(4) = {0, 3, 0, size};
Point(5) = {0, 1, 0, size};
Line(1) = {2, 3};
Circle(2) = {3, 1, 4};
Line(3) = {4, 5};
Circle(4) = {5, 1, 2};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Surface("rock") = {1};
Physical Curve("bottom") = {1};
Physical Curve("outer") = {2};
Physical Curve("side") = {3};
Physical Curve("inner") = {4};
