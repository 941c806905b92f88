// Two regions side by side; in the left one two fractures that cross and end inside. Point 12 is
// part of nothing. The four .msh files beside this one were made from it by gmsh 4.8.4:
//   gmsh -2 -format msh22 -o two_regions_22_text.msh two_regions.geo
//   and so on: with msh41 for version 4.1, with -bin for the binary files.
size = 0.5;
Point(1) = {0, 0, 0, size};
Point(2) = {1, 0, 0, size};
Point(3) = {2, 0, 0, size};
Point(4) = {2, 1, 0, size};
Point(5) = {1, 1, 0, size};
Point(6) = {0, 1, 0, size};
Point(7) = {0.25, 0.5, 0, size};
Point(8) = {0.5, 0.5, 0, size};
Point(9) = {0.75, 0.5, 0, size};
Point(10) = {0.5, 0.25, 0, size};
Point(11) = {0.5, 0.75, 0, size};
Point(12) = {1.5, 5, 0, size};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Line(5) = {5, 6};
Line(6) = {6, 1};
Line(7) = {2, 5};
Line(8) = {7, 8};
Line(9) = {8, 9};
Line(10) = {10, 8};
Line(11) = {8, 11};
Curve Loop(1) = {1, 7, 5, 6};
Curve Loop(2) = {2, 3, 4, -7};
Plane Surface(1) = {1};
Plane Surface(2) = {2};
Curve{8, 9, 10, 11} In Surface{1};
Physical Surface("sand stone") = {1};
Physical Surface("clay") = {2};
Physical Curve("left") = {6};
Physical Curve("right") = {3};
Physical Curve("across") = {8, 9};
Physical Curve("up") = {10, 11};
Physical Curve("fractures") = {8, 9, 10, 11};
Physical Curve(77) = {7};
Physical Curve("outline") = {-6, 1, 2, 3};
Physical Point("crossing") = {8};
