// SPDX-License-Identifier: BSD-3-Clause
// Rock from x = -20 m to 100 m, 10 m high, cut by a fracture at x = 0 over the whole height.
// size: element size at the fracture; it grows to five times that far to the right.
// Shipped mesh: gmsh -2 -format msh41 -bin single_fracture.geo
DefineConstant[ size = 0.5 ];

Point(1) = {-20, 0, 0, 2*size};
Point(2) = {0, 0, 0, size};
Point(3) = {100, 0, 0, 5*size};
Point(4) = {100, 10, 0, 5*size};
Point(5) = {0, 10, 0, size};
Point(6) = {-20, 10, 0, 2*size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Line(7) = {2, 5};
Curve Loop(1) = {1, 7, 5, 6};
Curve Loop(2) = {2, 3, 4, -7};
Plane Surface(1) = {1};
Plane Surface(2) = {2};

Physical Surface("rock") = {1, 2};
Physical Curve("fracture") = {7};
