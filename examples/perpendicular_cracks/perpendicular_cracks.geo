// SPDX-License-Identifier: BSD-3-Clause
// Rock of 4 m by 4 m with a horizontal crack of 0.8 m and, to its right, a vertical one of 0.8 m.
// size: element size, m.
// gmsh -2 -format msh41 -bin -o perpendicular_cracks.msh perpendicular_cracks.geo
// and with -setnumber size 0.09 as perpendicular_cracks_fine.msh
DefineConstant[ size = 0.15 ];
Mesh.Algorithm = 5;  // irregular: cracks follow the edges of triangles
half = 2;

Point(1) = {-half, -half, 0, size};
Point(2) = {half, -half, 0, size};
Point(3) = {half, half, 0, size};
Point(4) = {-half, half, 0, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};

Point(11) = {-0.9, 0, 0, size};
Point(12) = {-0.5, 0, 0, size};  // its middle, where the fluid enters
Point(13) = {-0.1, 0, 0, size};
Point(21) = {0.3, -0.4, 0, size};
Point(22) = {0.3, 0, 0, size};   // its middle, where the fluid enters
Point(23) = {0.3, 0.4, 0, size};
Line(11) = {11, 12};
Line(12) = {12, 13};
Line(21) = {21, 22};
Line(22) = {22, 23};
Curve{11, 12, 21, 22} In Surface{1};

Physical Surface("rock") = {1};
Physical Curve("outer") = {1:4};
Physical Curve("horizontal") = {11, 12};
Physical Curve("vertical") = {21, 22};
