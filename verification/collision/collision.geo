// SPDX-License-Identifier: BSD-3-Clause
// Two discs, of radius 0.5 m and 0.35 m, 0.05 m apart; the right one lies 0.1 m higher.
// gmsh -2 -format msh41 -bin -o collision.msh collision.geo
h = 0.07;
Mesh.Algorithm = 5;
Macro Disc
  p = newp;
  Point(p) = {cx, cy, 0, h};
  Point(p + 1) = {cx + r, cy, 0, h};
  Point(p + 2) = {cx, cy + r, 0, h};
  Point(p + 3) = {cx - r, cy, 0, h};
  Point(p + 4) = {cx, cy - r, 0, h};
  c = newl;
  Circle(c) = {p + 1, p, p + 2};
  Circle(c + 1) = {p + 2, p, p + 3};
  Circle(c + 2) = {p + 3, p, p + 4};
  Circle(c + 3) = {p + 4, p, p + 1};
  l = newll;
  Curve Loop(l) = {c, c + 1, c + 2, c + 3};
  s = news;
  Plane Surface(s) = {l};
Return
cx = -0.55; cy = 0; r = 0.5;
Call Disc;
Physical Surface("large") = {s};
cx = 0.35; cy = 0.1; r = 0.35;
Call Disc;
Physical Surface("small") = {s};
