"""What a joint file leaves out, and what is taken instead: a module for each part of a joint."""
