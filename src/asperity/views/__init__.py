"""What there is to read about a joint, once: blocks of words, numbers and tables that every screen and page shows."""
