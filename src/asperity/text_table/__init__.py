"""Text files that hold one table of numbers: encoding, layout, headings, and what is stated around the table."""
