"""What a script or a notebook calls: joint files and measured files in, results with names and units out.

Everything here is a thin layer over the rooms below. ``import asperity`` offers its functions lazily; each of them
switches JAX to double precision and sets the cache of compiled programs.
"""
