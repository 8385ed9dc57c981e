"""Accuracy of the fractal law: comparison with boundary elements and Persson's theory on the surfaces it assumes."""
