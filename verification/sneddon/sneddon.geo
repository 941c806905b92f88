// SPDX-License-Identifier: BSD-3-Clause
// The right half of a box of 40 m with a crack from x = -1 m to 1 m. size: elements of the crack, m.
// gmsh -2 -format msh41 -bin -setnumber size 0.0125 -o sneddon_80.msh sneddon.geo
// and with 0.025 and 0.05 as sneddon_40.msh and sneddon_20.msh
DefineConstant[ size = 0.025 ];
Mesh.Algorithm = 5;
Point(1) = {0, -20, 0, 100 * size};
Point(2) = {20, -20, 0, 100 * size};
Point(3) = {20, 20, 0, 100 * size};
Point(4) = {0, 20, 0, 100 * size};
Point(5) = {0, 0, 0, size};
Point(6) = {1, 0, 0, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 1};
Line(6) = {5, 6};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};
Curve{6} In Surface{1};
// Elements grow slowly near the crack: a box field of evenly fine ones would cost too many.
Field[1] = Distance;
Field[1].EdgesList = {6};
Field[1].NNodesByEdge = 400;
Field[2] = MathEval;
Field[2].F = Sprintf("%g + 0.15 * F1", size);
Background Field = 2;
Mesh.MeshSizeExtendFromBoundary = 0;
Mesh.MeshSizeFromPoints = 0;
Physical Surface("rock") = {1};
Physical Curve("outer") = {1, 2, 3};
Physical Curve("symmetry") = {4, 5};
Physical Curve("crack") = {6};
