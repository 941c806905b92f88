// SPDX-License-Identifier: BSD-3-Clause
// A specimen of 0.05 m by 0.1 m between two platens. size: element size in the specimen, m.
// gmsh -2 -format msh41 -bin -o compression.msh compression.geo
// and with -setnumber size 0.0018 and 0.00125 as compression_medium.msh and compression_fine.msh
DefineConstant[ size = 0.0025 ];
coarse = 0.01;
Mesh.Algorithm = 5;
Point(1) = {-0.025, 0, 0, size};
Point(2) = {0.025, 0, 0, size};
Point(3) = {0.025, 0.1, 0, size};
Point(4) = {-0.025, 0.1, 0, size};
Point(5) = {-0.035, 0, 0, coarse};
Point(6) = {-0.035, -0.01, 0, coarse};
Point(7) = {0.035, -0.01, 0, coarse};
Point(8) = {0.035, 0, 0, coarse};
Point(9) = {0.035, 0.1, 0, coarse};
Point(10) = {0.035, 0.11, 0, coarse};
Point(11) = {-0.035, 0.11, 0, coarse};
Point(12) = {-0.035, 0.1, 0, coarse};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Line(5) = {1, 5};
Line(6) = {5, 6};
Line(7) = {6, 7};
Line(8) = {7, 8};
Line(9) = {8, 2};
Line(10) = {3, 9};
Line(11) = {9, 10};
Line(12) = {10, 11};
Line(13) = {11, 12};
Line(14) = {12, 4};
Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {5, 6, 7, 8, 9, -1};
Curve Loop(3) = {10, 11, 12, 13, 14, -3};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Plane Surface(3) = {3};
Physical Surface("rock") = {1};
Physical Surface("bottom_platen") = {2};
Physical Surface("top_platen") = {3};
Physical Curve("faces") = {1, 3};
Physical Curve("sides") = {2, 4};
