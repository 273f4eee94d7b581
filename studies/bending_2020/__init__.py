"""Hall, Sirnivas & Yu 2020, "Implementation and Verification of Cable Bending Stiffness in MoorDyn"."""
