// The box of system/blockMeshDict in triangles, extruded by one cell
h = 0.01;
Point(1) = {0,   0,   0, h};
Point(2) = {0.1, 0,   0, h};
Point(3) = {0.1, 0.1, 0, h};
Point(4) = {0,   0.1, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
e[] = Extrude {0, 0, 0.01} { Surface{1}; Layers{1}; Recombine; };

Physical Volume("fluid") = {e[1]};
Physical Surface("bottom") = {e[2]};
Physical Surface("right") = {e[3]};
Physical Surface("top") = {e[4]};
Physical Surface("left") = {e[5]};
Physical Surface("frontAndBack") = {1, e[0]};
