"""What a drive is: bodies, contacts and pins, their places and their motion."""
