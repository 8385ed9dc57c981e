"""What the commands do: a module for each, imported only when its command runs.

Its function has the name of the command, and the options of the command as arguments. All imports stand at the top.
"""
