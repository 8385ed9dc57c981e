"""How good is the fractal law? Boundary elements and Persson's theory beside it, on the surfaces it assumes."""
