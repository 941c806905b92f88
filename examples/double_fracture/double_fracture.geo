// SPDX-License-Identifier: BSD-3-Clause
// HYDROCOIN level 1, test case 2: two faults that crop out in two valleys and cross at depth.
// y is the elevation above the level 1000 m below the datum of the head.
// Shipped meshes: gmsh -2 -format msh41 -bin -setnumber size 62.6 double_fracture.geo
DefineConstant[ size = 62.6 ];

Point(1) = {0, 1150, 0, size};
Point(2) = {400, 1100, 0, size/2};
Point(3) = {800, 1150, 0, size};
Point(4) = {1200, 1100, 0, size/2};
Point(5) = {1600, 1150, 0, size};
Point(6) = {1600, 0, 0, size};
Point(7) = {1500, 0, 0, size};
Point(8) = {1000, 0, 0, size};
Point(9) = {0, 0, 0, size};
Point(10) = {14000/13, 5500/13, 0, size};  // the crossing of the faults

Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 7};
Line(7) = {7, 8};
Line(8) = {8, 9};
Line(9) = {9, 1};
Line(10) = {2, 10};  // western fault, upper and lower part
Line(11) = {10, 7};
Line(12) = {4, 10};  // eastern fault, upper and lower part
Line(13) = {10, 8};

Curve Loop(1) = {-9, -8, -13, -10, -1};
Curve Loop(2) = {10, -12, -3, -2};
Curve Loop(3) = {12, 11, -6, -5, -4};
Curve Loop(4) = {13, -7, -11};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Plane Surface(3) = {3};
Plane Surface(4) = {4};

Physical Surface("rock") = {1, 2, 3, 4};
Physical Curve("ground") = {1, 2, 3, 4};
Physical Curve("western fault") = {10, 11};
Physical Curve("eastern fault") = {12, 13};
