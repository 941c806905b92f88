// SPDX-License-Identifier: BSD-3-Clause
// Two arms of 0.6 m by 0.1 m, open over 0.3 m; the crack may run on over 0.15 m of the middle line.
// size: element size along that line, m.
// gmsh -2 -format msh41 -bin -o double_cantilever.msh double_cantilever.geo
// and with -setnumber size 0.001 as double_cantilever_fine.msh
DefineConstant[ size = 0.002 ];
coarse = 0.016;
Mesh.Algorithm = 5;
Point(1) = {0, -0.1, 0, coarse};
Point(2) = {0.6, -0.1, 0, coarse};
Point(3) = {0.6, 0.1, 0, coarse};
Point(4) = {0, 0.1, 0, coarse};
Point(5) = {0, 0, 0, coarse};
Point(6) = {0.3, 0, 0, size};
Point(7) = {0.45, 0, 0, size};
Point(8) = {0.6, 0, 0, coarse};
Line(1) = {1, 2};
Line(2) = {2, 8};
Line(3) = {8, 3};
Line(4) = {3, 4};
Line(5) = {4, 5};
Line(6) = {5, 1};
Line(7) = {5, 6};
Line(8) = {6, 7};
Line(9) = {7, 8};
Curve Loop(1) = {1, 2, -9, -8, -7, 6};
Curve Loop(2) = {7, 8, 9, 3, 4, 5};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Physical Surface("rock") = {1, 2};
Physical Curve("lower_end") = {6};
Physical Curve("upper_end") = {5};
Physical Curve("notch") = {7};
Physical Curve("line") = {8};
