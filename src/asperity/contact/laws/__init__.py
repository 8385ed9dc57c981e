"""The contact laws, a file each, named after the law: what is in this folder can be asked for in a joint file."""
