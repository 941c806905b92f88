// SPDX-License-Identifier: BSD-3-Clause
// A strip of 2 m by 0.05 m along which plane waves run.
// gmsh -2 -format msh41 -bin -o waves.msh waves.geo
h = 0.0125;
Mesh.Algorithm = 5;
Point(1) = {0, 0, 0, h};
Point(2) = {2, 0, 0, h};
Point(3) = {2, 0.05, 0, h};
Point(4) = {0, 0.05, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Physical Surface("rock") = {1};
Physical Curve("sides") = {1, 3};
Physical Curve("right") = {2};
Physical Curve("left") = {4};
