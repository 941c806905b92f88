// SPDX-License-Identifier: BSD-3-Clause
// The right half of the rock round a borehole of r = 0.1 m, out to 2 m, with a line along x on which it may break.
// gmsh -2 -format msh41 -bin -o breakdown.msh breakdown.geo
size = 0.00125;
Mesh.Algorithm = 5;
Point(1) = {0, 0, 0, 1};
Point(2) = {0, -2, 0, 0.3};
Point(3) = {2, 0, 0, 0.3};
Point(4) = {0, 2, 0, 0.3};
Point(5) = {0, 0.1, 0, 6 * size};
Point(6) = {0.1, 0, 0, size};
Point(7) = {0, -0.1, 0, 6 * size};
Point(8) = {0.12, 0, 0, size};
Circle(1) = {2, 1, 3};
Circle(2) = {3, 1, 4};
Line(3) = {4, 5};
Circle(4) = {5, 1, 6};
Circle(5) = {6, 1, 7};
Line(6) = {7, 2};
Line(7) = {6, 8};
Curve Loop(1) = {1, 2, 3, 4, 5, 6};
Plane Surface(1) = {1};
Curve{7} In Surface{1};
Physical Surface("rock") = {1};
Physical Curve("outer") = {1, 2};
Physical Curve("symmetry") = {3, 6};
Physical Curve("wall") = {4, 5};
Physical Curve("line") = {7};
