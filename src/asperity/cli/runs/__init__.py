"""What the commands do: a module for each, imported only when its command runs.

Its function has the name of the command, and the options of the command as arguments. Imports stand at the top, but for
those of what an option alone needs, and of JAX behind the refusal of a missing file.
"""
