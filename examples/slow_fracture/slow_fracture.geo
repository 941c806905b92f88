// SPDX-License-Identifier: BSD-3-Clause
// The right half of rock with a seed crack up to x = seed and a line along which it may grow, to x = end, m.
// gmsh -2 -format msh41 -bin -o slow_fracture.msh slow_fracture.geo
DefineConstant[ seed = 0.2, end = 2.2 ];
size = 0.01;
far = 60;
Mesh.Algorithm = 5;
Point(1) = {0, -far, 0, 10};
Point(2) = {far, -far, 0, 10};
Point(3) = {far, far, 0, 10};
Point(4) = {0, far, 0, 10};
Point(5) = {0, 0, 0, size};
Point(6) = {seed, 0, 0, size};
Point(7) = {end, 0, 0, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 1};
Line(6) = {5, 6};
Line(7) = {6, 7};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};
Curve{6, 7} In Surface{1};
Field[1] = Distance;
Field[1].EdgesList = {6, 7};
Field[1].NNodesByEdge = 1000;
Field[2] = MathEval;
Field[2].F = Sprintf("%g + 0.4 * F1", size);
Transfinite Curve{6} = Round(seed / size) + 1;
Transfinite Curve{7} = Round((end - seed) / size) + 1;
Background Field = 2;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Physical Surface("rock") = {1};
Physical Curve("outer") = {1, 2, 3};
Physical Curve("symmetry") = {4, 5};
Physical Curve("seed") = {6};
Physical Curve("line") = {7};
