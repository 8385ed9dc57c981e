"""One document about a joint for a design review: what it says, and how HTML and PDF show it."""
