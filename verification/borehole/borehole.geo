// SPDX-License-Identifier: BSD-3-Clause
// A quarter of the rock round a hole of r = 0.1 m, out to 4 m; finer up to 0.6 m.
// gmsh -2 -format msh41 -bin -o borehole.msh borehole.geo
Mesh.Algorithm = 5;
Point(1) = {0, 0, 0, 1};
Point(2) = {0.1, 0, 0, 0.008};
Point(3) = {0.6, 0, 0, 0.04};
Point(4) = {4, 0, 0, 0.4};
Point(5) = {0, 4, 0, 0.4};
Point(6) = {0, 0.6, 0, 0.04};
Point(7) = {0, 0.1, 0, 0.008};
Line(1) = {2, 3};
Line(2) = {3, 4};
Circle(3) = {4, 1, 5};
Line(4) = {5, 6};
Line(5) = {6, 7};
Circle(6) = {7, 1, 2};
Circle(7) = {3, 1, 6};
Curve Loop(1) = {1, 7, 5, 6};
Curve Loop(2) = {2, 3, 4, -7};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Physical Surface("rock") = {1, 2};
Physical Curve("axes") = {1, 2, 4, 5};
Physical Curve("outer") = {3};
Physical Curve("wall") = {6};
