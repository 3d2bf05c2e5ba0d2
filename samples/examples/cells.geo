// Two cells in a box, for Gmsh: curves of order 2 need no more.
SetFactory("OpenCASCADE");
Rectangle(1) = {-2, -1, 0, 4, 2};
Disk(2) = {-0.8, 0, 0, 0.6, 0.4};
Disk(3) = {0.8, 0.1, 0, 0.5};
BooleanFragments{ Surface{1}; Delete; }{ Surface{2, 3}; Delete; }
Physical Surface("first") = {2};
Physical Surface("second") = {3};
Physical Surface("around") = {4};
Mesh.MeshSizeMax = 0.4;
