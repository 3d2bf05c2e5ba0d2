#!/usr/bin/env python3
"""Times DOLFINx on -div grad u = 1, u = 0 on the boundary, on the curved elements of a mesh that export-msh --format msh22 wrote.
Usage: finite_elements_dolfinx.py MESH.msh [SOLVER ...]; solvers are mumps, gamg (conjugate gradients with PETSc's multigrid)."""
import sys
from time import process_time

import numpy as np
import ufl
from dolfinx import cpp, fem, mesh
from dolfinx.fem import petsc
from mpi4py import MPI
from petsc4py import PETSc

TRIANGLES = {9: 2, 21: 3}  # Gmsh's types: degree; perm_gmsh refuses degree 4
SOLVERS = {"mumps": {"ksp_type": "preonly", "pc_type": "cholesky", "pc_factor_mat_solver_type": "mumps",
                     "mat_mumps_icntl_7": 0},  # minimum degree: in two dimensions the fastest of its orders
           "gamg": {"ksp_type": "cg", "pc_type": "gamg", "ksp_norm_type": "unpreconditioned", "ksp_rtol": 1e-10,
                    "ksp_max_it": 500}}


def read(path):
    """Points, triangles and Gmsh's type of them."""
    lines = iter(open(path))
    points, triangles, kind = {}, [], 0
    for line in lines:
        if line.startswith("$Nodes"):
            for _ in range(int(next(lines))):
                node = next(lines).split()
                points[int(node[0])] = len(points), float(node[1]), float(node[2])
        elif line.startswith("$Elements"):
            for _ in range(int(next(lines))):
                element = [int(word) for word in next(lines).split()]
                if element[1] in TRIANGLES:
                    kind = element[1]
                    triangles.append([points[i][0] for i in element[3 + element[2]:]])
    return np.array([point[1:] for point in points.values()]), np.array(triangles, dtype=np.int64), kind


def assemble(forms):
    """Matrices of compiled forms with patterns made anew, and the processor seconds of that."""
    start = process_time()
    made = [petsc.create_matrix(form) for form in forms]
    patterns = process_time() - start
    for matrix, form in zip(made, forms):
        petsc.assemble_matrix(matrix, form)
        matrix.assemble()
    return made, patterns, process_time() - start - patterns


def main(path, *solvers):
    points, triangles, kind = read(path)
    triangles = triangles[:, cpp.io.perm_gmsh(mesh.CellType.triangle, triangles.shape[1])]
    shape = ufl.VectorElement(ufl.FiniteElement("Lagrange", ufl.Cell("triangle", 2), TRIANGLES[kind], variant="equispaced"))
    start = process_time()
    domain = mesh.create_mesh(MPI.COMM_SELF, triangles, points, ufl.Mesh(shape))
    space = fem.FunctionSpace(domain, ("Lagrange", TRIANGLES[kind]))
    domain.topology.create_connectivity(1, 2)
    print(f"mesh and space {process_time() - start:.2f} s")

    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    one = fem.Constant(domain, PETSc.ScalarType(1))
    for quadrature in 4 * TRIANGLES[kind] - 2, None:
        dx = ufl.dx(metadata={"quadrature_degree": quadrature}) if quadrature else ufl.dx
        mass, stiffness = fem.form(u * v * dx), fem.form(ufl.inner(ufl.grad(u), ufl.grad(v)) * dx)
        _, patterns, fill = assemble([mass, stiffness])
        print(f"elements {len(triangles)} unknowns {space.dofmap.index_map.size_global} quadrature {quadrature or 'own'}: "
              f"mass + stiffness {fill:.2f} s + patterns {patterns:.2f} s, {len(triangles) / fill:.0f} a second")

    dx = ufl.dx(metadata={"quadrature_degree": 4 * TRIANGLES[kind] - 2})
    form, load = fem.form(ufl.inner(ufl.grad(u), ufl.grad(v)) * dx), fem.form(one * v * dx)
    rim = fem.dirichletbc(PETSc.ScalarType(0),
                          fem.locate_dofs_topological(space, 1, cpp.mesh.exterior_facet_indices(domain.topology)), space)
    for solver in solvers:
        start = process_time()
        matrix = petsc.assemble_matrix(form, bcs=[rim])
        matrix.assemble()
        matrix.setOption(PETSc.Mat.Option.SPD, True)
        b = petsc.assemble_vector(load)
        petsc.apply_lifting(b, [form], bcs=[[rim]])
        petsc.set_bc(b, [rim])
        assembly = process_time() - start
        start = process_time()
        ksp = PETSc.KSP().create(MPI.COMM_SELF)
        options = PETSc.Options()
        for key, value in SOLVERS[solver].items():
            options[key] = value
        ksp.setOperators(matrix)
        ksp.setFromOptions()
        solution = fem.Function(space)
        ksp.setUp()
        for key in SOLVERS[solver]:
            options.delValue(key)
        factor = process_time() - start
        ksp.solve(b, solution.vector)
        solve = process_time() - start - factor
        residual = (b - matrix * solution.vector).norm() / b.norm()
        integral = fem.assemble_scalar(fem.form(solution * ufl.dx))
        print(f"{solver}: assembly {assembly:.2f} s, factor {factor:.2f} s, solve {solve:.2f} s, "
              f"{ksp.getIterationNumber()} iterations, residual {residual:.1e}, integral {integral:.12g}")


main(sys.argv[1], *(sys.argv[2:] or SOLVERS))
