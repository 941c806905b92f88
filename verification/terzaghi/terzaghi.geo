// SPDX-License-Identifier: BSD-3-Clause
// A column 1 m high and 0.12 m wide.
// gmsh -2 -format msh41 -bin -o terzaghi.msh terzaghi.geo
h = 0.04;
Mesh.Algorithm = 5;
Point(1) = {0, 0, 0, h};
Point(2) = {0.12, 0, 0, h};
Point(3) = {0.12, 1, 0, h};
Point(4) = {0, 1, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Surface("rock") = {1};
Physical Curve("walls") = {1, 2, 4};
Physical Curve("top") = {3};
