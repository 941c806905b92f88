// SPDX-License-Identifier: BSD-3-Clause
// Rock of 4 m by 4 m with three cracks of 0.2 m from its left side, 0.3 m apart.
// size: element size at the left side, m; it grows to far times that at the right.
// gmsh -2 -format msh41 -bin -o three_cracks.msh three_cracks.geo
// and with -setnumber size 0.07 as three_cracks_coarse.msh
DefineConstant[ size = 0.05, far = 1.12 ];
Mesh.Algorithm = 5;  // irregular: cracks follow the edges of triangles
half = 2;
length = 0.2;
apart = 0.3;

Point(1) = {0, -half, 0, size};
Point(2) = {4, -half, 0, far*size};
Point(3) = {4, half, 0, far*size};
Point(4) = {0, half, 0, size};
For i In {0:2}
  y = (i - 1)*apart;
  Point(11 + i) = {0, y, 0, size};       // mouth, where the fluid enters
  Point(21 + i) = {length, y, 0, size};  // tip
  Line(31 + i) = {11 + i, 21 + i};
EndFor
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 13};
Line(5) = {13, 12};
Line(6) = {12, 11};
Line(7) = {11, 1};
Curve Loop(1) = {1:7};
Plane Surface(1) = {1};
Curve{31:33} In Surface{1};

Physical Surface("rock") = {1};
Physical Curve("left") = {4:7};
Physical Curve("far") = {1:3};
Physical Curve("lower_crack") = {31};
Physical Curve("middle_crack") = {32};
Physical Curve("upper_crack") = {33};
