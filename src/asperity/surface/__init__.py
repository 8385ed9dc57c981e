"""What a rough surface is: generators, spectra, structure functions, fractal parameters, instrument files."""
