// SPDX-License-Identifier: BSD-3-Clause
// Unit square with the regular network of six fractures of Flemisch et al. (2018), case 1.
// Shipped mesh: gmsh -2 -format msh41 -bin flemisch_regular.geo
// size: element size at the fractures; it grows to three times that away from them.
DefineConstant[ size = 0.0125 ];

far = 3*size;
Point(1) = {0, 0, 0, far};
Point(2) = {0.5, 0, 0, size};
Point(3) = {1, 0, 0, far};
Point(4) = {1, 0.5, 0, size};
Point(5) = {1, 0.75, 0, size};
Point(6) = {1, 1, 0, far};
Point(7) = {0.75, 1, 0, size};
Point(8) = {0.5, 1, 0, size};
Point(9) = {0, 1, 0, far};
Point(10) = {0, 0.5, 0, size};
Point(11) = {0.5, 0.5, 0, size};
Point(12) = {0.625, 0.5, 0, size};
Point(13) = {0.75, 0.5, 0, size};
Point(14) = {0.5, 0.625, 0, size};
Point(15) = {0.625, 0.625, 0, size};
Point(16) = {0.75, 0.625, 0, size};
Point(17) = {0.5, 0.75, 0, size};
Point(18) = {0.625, 0.75, 0, size};
Point(19) = {0.75, 0.75, 0, size};

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 8};
Line(8) = {8, 9};
Line(9) = {9, 10};
Line(10) = {10, 1};
Line(11) = {10, 11};  // y = 0.5
Line(12) = {11, 12};
Line(13) = {12, 13};
Line(14) = {13, 4};
Line(15) = {2, 11};   // x = 0.5
Line(16) = {11, 14};
Line(17) = {14, 17};
Line(18) = {17, 8};
Line(19) = {17, 18};  // y = 0.75
Line(20) = {18, 19};
Line(21) = {19, 5};
Line(22) = {13, 16};  // x = 0.75
Line(23) = {16, 19};
Line(24) = {19, 7};
Line(25) = {14, 15};  // y = 0.625
Line(26) = {15, 16};
Line(27) = {12, 15};  // x = 0.625
Line(28) = {15, 18};

Curve Loop(1) = {1, 15, -11, 10};
Curve Loop(2) = {2, 3, -14, -13, -12, -15};
Curve Loop(3) = {11, 16, 17, 18, 8, 9};
Curve Loop(4) = {12, 27, -25, -16};
Curve Loop(5) = {13, 22, -26, -27};
Curve Loop(6) = {25, 28, -19, -17};
Curve Loop(7) = {26, 23, -20, -28};
Curve Loop(8) = {14, 4, -21, -23, -22};
Curve Loop(9) = {19, 20, 24, 7, -18};
Curve Loop(10) = {21, 5, 6, -24};
For i In {1:10}
  Plane Surface(i) = {i};
EndFor

Physical Surface("rock") = {1:10};
Physical Curve("left") = {9, 10};
Physical Curve("right") = {3, 4, 5};
Physical Curve("network") = {11:28};
